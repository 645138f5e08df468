package org.u2sa.recorder.execution;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.FieldValue;
import org.u2sa.messages.schema.U2SAData;

/** Numbers of a message, except its timestamp. */
final class MessageNumbers {
  private static final int MOST = 256; // grids have many more

  /** A number with the path of its field, such as {@code goals[2].x}; the unit may be empty. */
  record At(String field, String unit, double value) {}

  private final List<At> all = new ArrayList<>();

  private MessageNumbers() {}

  static List<At> of(U2SAData message) {
    MessageNumbers numbers = new MessageNumbers();
    numbers.collect("", "", message);
    return numbers.all;
  }

  private void collect(String path, String unit, Object value) {
    if (all.size() >= MOST) {
      return;
    }
    if (value instanceof Number number) {
      all.add(new At(path, unit, number.doubleValue()));
    } else if (value instanceof Point point) {
      all.add(new At(path + ".x", unit, point.x()));
      all.add(new At(path + ".y", unit, point.y()));
      all.add(new At(path + ".z", unit, point.z()));
    } else if (value instanceof U2SAData message) {
      String prefix = path.isEmpty() ? "" : path + ".";
      for (FieldValue field : message.enumerateFields()) {
        if (!field.name().equals("timestamp") && field.value().isPresent()) {
          collect(prefix + field.name(), field.unit(), field.value().get());
        }
      }
    } else if (value instanceof List<?> list) {
      int i = 0;
      for (Object element : list) {
        collect(path + "[" + i++ + "]", unit, element);
      }
    }
  }
}
