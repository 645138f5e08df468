package org.u2sa.messages.schema;

/**
 * Thrown for bytes that are not a valid message; names the position, the field and what was
 * expected.
 */
public final class MalformedMessageException extends Exception {
  private static final long serialVersionUID = 1L;

  private final long offset;

  MalformedMessageException(String where, long offset, String what) {
    super(where + ", byte " + offset + ": " + what);
    this.offset = offset;
  }

  MalformedMessageException(String where, long offset, String what, Throwable cause) {
    super(where + ", byte " + offset + ": " + what, cause);
    this.offset = offset;
  }

  /** Offset of the byte at which reading stopped. */
  public long offset() {
    return offset;
  }
}
