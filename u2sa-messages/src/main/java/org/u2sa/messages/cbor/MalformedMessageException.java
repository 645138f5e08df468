package org.u2sa.messages.cbor;

/**
 * Thrown for bytes that are not a valid message; names the position, the field and what was
 * expected.
 */
public final class MalformedMessageException extends Exception {
  private static final long serialVersionUID = 1L;

  private final long offset;

  /**
   * @param where type and field of the message
   * @param offset offset of the byte at which reading stopped
   * @param what expected content
   */
  public MalformedMessageException(String where, long offset, String what) {
    super(where + ", byte " + offset + ": " + what);
    this.offset = offset;
  }

  /** The same with a cause. */
  public MalformedMessageException(String where, long offset, String what, Throwable cause) {
    super(where + ", byte " + offset + ": " + what, cause);
    this.offset = offset;
  }

  /** Offset of the byte at which reading stopped. */
  public long offset() {
    return offset;
  }
}
