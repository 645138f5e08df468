package org.u2sa.messages.cbor;

/**
 * Thrown for bytes that are not a valid message; names the position, the field and what was
 * expected.
 */
public final class MalformedMessageException extends Exception {
  private static final long serialVersionUID = 1L;

  private final long offset;
  private final String reason;

  /**
   * @param where type and field of the message
   * @param offset offset of the byte at which reading stopped
   * @param what expected content
   */
  public MalformedMessageException(String where, long offset, String what) {
    super(where + ", byte " + offset + ": " + what);
    this.offset = offset;
    reason = what;
  }

  /** The same with a cause. */
  public MalformedMessageException(String where, long offset, String what, Throwable cause) {
    super(where + ", byte " + offset + ": " + what, cause);
    this.offset = offset;
    reason = what;
  }

  /** Offset of the byte at which reading stopped. */
  public long offset() {
    return offset;
  }

  /** The message without the position in the bytes. */
  public String reason() {
    return reason;
  }
}
