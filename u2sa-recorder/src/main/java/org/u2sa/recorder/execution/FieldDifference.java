package org.u2sa.recorder.execution;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.schema.FieldValue;
import org.u2sa.messages.schema.U2SAData;

/**
 * First difference of two messages.
 *
 * @param field path of the field, such as {@code goals[2].x}
 * @param recorded recorded value; empty if absent
 * @param now value from the re-execution
 */
public record FieldDifference(String field, String recorded, String now) {
  /**
   * First difference in field order, or empty.
   *
   * @param asRecorded replaces what differs by design in a text of the re-execution
   */
  static Optional<FieldDifference> between(
      U2SAData recorded, U2SAData now, UnaryOperator<String> asRecorded) {
    return between("", recorded, now, asRecorded);
  }

  private static Optional<FieldDifference> between(
      String path, U2SAData a, U2SAData b, UnaryOperator<String> asRecorded) {
    if (!a.typeChain().equals(b.typeChain())) {
      return Optional.of(new FieldDifference(path + "type", a.type().name(), b.type().name()));
    }
    List<FieldValue> ofA = a.enumerateFields();
    List<FieldValue> ofB = b.enumerateFields();
    for (int i = 0; i < Math.max(ofA.size(), ofB.size()); i++) {
      String name = path + (i < ofA.size() ? ofA.get(i) : ofB.get(i)).name();
      Object valueOfA = i < ofA.size() ? ofA.get(i).value().orElse("") : "";
      Object valueOfB = i < ofB.size() ? ofB.get(i).value().orElse("") : "";
      Optional<FieldDifference> found = between(name, valueOfA, valueOfB, asRecorded);
      if (found.isPresent()) {
        return found;
      }
    }
    return Optional.empty();
  }

  private static Optional<FieldDifference> between(
      String path, Object a, Object b, UnaryOperator<String> asRecorded) {
    if (a.equals(b) || b instanceof String text && a.equals(asRecorded.apply(text))) {
      return Optional.empty();
    }
    if (a instanceof U2SAData one && b instanceof U2SAData other) {
      return between(path + ".", one, other, asRecorded);
    }
    if (a instanceof List<?> ofA && b instanceof List<?> ofB) {
      for (int i = 0; i < Math.min(ofA.size(), ofB.size()); i++) {
        Optional<FieldDifference> found =
            between(path + "[" + i + "]", ofA.get(i), ofB.get(i), asRecorded);
        if (found.isPresent()) {
          return found;
        }
      }
      return ofA.size() == ofB.size()
          ? Optional.empty()
          : Optional.of(
              new FieldDifference(path, ofA.size() + " elements", ofB.size() + " elements"));
    }
    if (a instanceof ByteString one && b instanceof ByteString other) {
      return Optional.of(betweenBytes(path, one, other));
    }
    return Optional.of(new FieldDifference(path, a.toString(), b.toString()));
  }

  /** First differing byte; the lengths if one is a prefix of the other. */
  private static FieldDifference betweenBytes(String path, ByteString a, ByteString b) {
    ByteBuffer ofA = a.view();
    ByteBuffer ofB = b.view();
    for (int i = 0; i < Math.min(a.length(), b.length()); i++) {
      if (ofA.get(i) != ofB.get(i)) {
        return new FieldDifference(path + "[" + i + "]", hex(ofA.get(i)), hex(ofB.get(i)));
      }
    }
    return new FieldDifference(path, a.toString(), b.toString());
  }

  private static String hex(byte value) {
    return String.format("0x%02x", value & 0xFF);
  }
}
