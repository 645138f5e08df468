package org.u2sa.messages.schema;

import java.util.List;

/**
 * How values of one {@link Kind} are checked, parsed, written and read. Errors of check and parse
 * say what was expected.
 */
interface ValueKind<V> {
  Kind kind();

  /** The value as it is kept: immutable and within bounds. */
  V checked(Object value);

  V parsed(List<String> texts);

  void write(CborOutput out, V value);

  V read(CborReader in) throws MalformedMessageException;

  /** What {@link #read} gives, {@link #checked}. */
  default V readChecked(CborReader in) throws MalformedMessageException {
    return checked(read(in));
  }

  /** The type of the messages in a list; null if it is no list of messages. */
  default MessageType<?> elementType() {
    return null;
  }

  /** Length up to which a text is within bounds without {@link #checked} having to look. */
  default int longest() {
    return Integer.MAX_VALUE;
  }

  /** Whether texts beyond {@link #longest} are shortened instead of refused. */
  default boolean shortens() {
    return false;
  }

  /** All values there are, if they are few; else empty. */
  default List<V> constants() {
    return List.of();
  }

  static String only(List<String> texts) {
    if (texts.size() != 1) {
      throw new IllegalArgumentException("expected one value");
    }
    return texts.get(0);
  }
}
