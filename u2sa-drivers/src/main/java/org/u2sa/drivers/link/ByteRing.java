package org.u2sa.drivers.link;

/** Ring buffer of unread bytes that drops the oldest. Not thread-safe. */
final class ByteRing {
  private final byte[] bytes;
  private int first;
  private int count;

  ByteRing(int capacity) {
    bytes = new byte[capacity];
  }

  /**
   * Appends bytes, dropping the oldest on overflow.
   *
   * @return number of bytes dropped
   */
  int put(byte[] from, int length) {
    int skipped = Math.max(0, length - bytes.length);
    int dropped = Math.max(0, count + length - skipped - bytes.length);
    first = (first + dropped) % bytes.length;
    count -= dropped;
    int at = (first + count) % bytes.length;
    int taken = length - skipped;
    int untilEnd = Math.min(taken, bytes.length - at);
    System.arraycopy(from, skipped, bytes, at, untilEnd);
    System.arraycopy(from, skipped + untilEnd, bytes, 0, taken - untilEnd);
    count += taken;
    return skipped + dropped;
  }

  /** Removes the oldest bytes; returns their number. */
  int take(byte[] to) {
    int taken = Math.min(to.length, count);
    int untilEnd = Math.min(taken, bytes.length - first);
    System.arraycopy(bytes, first, to, 0, untilEnd);
    System.arraycopy(bytes, 0, to, untilEnd, taken - untilEnd);
    first = (first + taken) % bytes.length;
    count -= taken;
    return taken;
  }

  void clear() {
    first = 0;
    count = 0;
  }
}
