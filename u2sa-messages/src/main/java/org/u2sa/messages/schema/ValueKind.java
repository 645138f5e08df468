package org.u2sa.messages.schema;

import java.util.List;
import org.u2sa.messages.cbor.CborOutput;
import org.u2sa.messages.cbor.MalformedMessageException;

/**
 * Checks, parses, writes and reads values of one {@link Kind}. Errors of check and parse name what
 * was expected.
 */
interface ValueKind<V> {
  Kind kind();

  /** The value as stored: immutable and within bounds. */
  V checked(Object value);

  V parsed(List<String> texts);

  void write(CborOutput out, V value);

  V read(CborReader in) throws MalformedMessageException;

  /** Result of {@link #read}, {@link #checked}. */
  default V readChecked(CborReader in) throws MalformedMessageException {
    return checked(read(in));
  }

  /** Length up to which any text is within bounds, so that {@link #checked} can be skipped. */
  default int longest() {
    return Integer.MAX_VALUE;
  }

  /** Whether overlong texts are truncated instead of rejected. */
  default boolean shortens() {
    return false;
  }

  /** All possible values, if enumerable; else empty. */
  default List<V> constants() {
    return List.of();
  }

  static String only(List<String> texts) {
    if (texts.size() != 1) {
      throw new IllegalArgumentException("expected one value");
    }
    return texts.get(0);
  }

  /** Thrown for an enum constant of a later data model version. */
  final class UnknownConstantException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    UnknownConstantException(String message) {
      super(message);
    }
  }
}
