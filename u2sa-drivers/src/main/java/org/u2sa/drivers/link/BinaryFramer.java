package org.u2sa.drivers.link;

import java.util.function.Consumer;

/**
 * Finds binary packets in a byte stream with arbitrary boundaries and garbage. A false start is
 * skipped, and the search resumes at its second byte. Not thread-safe.
 */
public abstract class BinaryFramer {
  /** No packet starts here. */
  protected static final int NONE = 0;

  private final byte[] bytes;
  private final Consumer<String> refusals;
  private int count;

  /**
   * @param longest length of the longest packet [bytes]
   * @param refusals receives the reason of each rejection
   */
  protected BinaryFramer(int longest, Consumer<String> refusals) {
    bytes = new byte[longest];
    this.refusals = refusals;
  }

  /**
   * Length of the packet that starts at an index, {@link #NONE}, or any number above {@code
   * available} if more bytes are needed to tell.
   *
   * @param available number of bytes from there on, at least 1
   */
  protected abstract int lengthAt(int at, int available);

  /** Reason to reject a complete packet; empty if it is intact. */
  protected abstract String fault(int at, int length);

  /** Handles an intact packet. */
  protected abstract void take(int at, int length);

  /** Consumes the first {@code length} bytes and delivers completed packets. */
  public final void accept(byte[] from, int length) {
    int taken = 0;
    while (taken < length) {
      int part = Math.min(length - taken, bytes.length - count);
      System.arraycopy(from, taken, bytes, count, part);
      count += part;
      taken += part;
      search();
    }
  }

  private void search() {
    int at = 0;
    int used = 1;
    while (used > 0 && at < count) {
      used = step(at);
      at += used;
    }
    System.arraycopy(bytes, at, bytes, 0, count - at);
    count -= at;
  }

  /** Number of bytes consumed; 0 if more are needed. */
  private int step(int at) {
    int length = lengthAt(at, count - at);
    if (length == NONE) {
      return 1;
    }
    if (count - at < length) {
      return 0;
    }
    String fault = fault(at, length);
    if (!fault.isEmpty()) {
      refuse(fault);
      return 1;
    }
    take(at, length);
    return length;
  }

  /** The bytes received, to which indices refer. */
  protected final byte[] bytes() {
    return bytes;
  }

  /** Reports a rejected packet. */
  protected final void refuse(String why) {
    refusals.accept(why);
  }

  /** The unsigned byte at an index. */
  protected final int unsigned8(int at) {
    return bytes[at] & 0xFF;
  }

  /** The unsigned little-endian number at an index. */
  protected final int unsigned16(int at) {
    return unsigned8(at) | unsigned8(at + 1) << 8;
  }

  /** Discards a partial packet. */
  public final void reset() {
    count = 0;
  }
}
