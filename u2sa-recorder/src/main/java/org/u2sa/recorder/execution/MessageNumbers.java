package org.u2sa.recorder.execution;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.FieldValue;
import org.u2sa.messages.schema.U2SAData;

/** Numbers of a message, except its timestamp. */
final class MessageNumbers {
  private static final int MOST = 256; // grids have many more

  /**
   * A number and its location.
   *
   * @param field path of the field, such as {@code goals[2].x}
   * @param unit its unit; empty if it has none
   */
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
    if (value instanceof Number) {
      all.add(new At(path, unit, ((Number) value).doubleValue()));
    } else if (value instanceof Point) {
      Point point = (Point) value;
      all.add(new At(path + ".x", unit, point.x()));
      all.add(new At(path + ".y", unit, point.y()));
      all.add(new At(path + ".z", unit, point.z()));
    } else if (value instanceof U2SAData) {
      String prefix = path.isEmpty() ? "" : path + ".";
      for (FieldValue field : ((U2SAData) value).enumerateFields()) {
        boolean counts = !field.name().equals("timestamp") && field.value().isPresent();
        if (counts) {
          collect(prefix + field.name(), field.unit(), field.value().get());
        }
      }
    } else if (value instanceof List<?>) {
      int i = 0;
      for (Object element : (List<?>) value) {
        collect(path + "[" + i++ + "]", unit, element);
      }
    }
  }
}
