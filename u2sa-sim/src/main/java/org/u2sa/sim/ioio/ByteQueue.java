package org.u2sa.sim.ioio;

/**
 * Fixed-capacity byte queue. As in the firmware, a write that does not fit is dropped whole,
 * silently.
 */
final class ByteQueue {
  private final byte[] buffer;
  private int first;
  private int size;

  ByteQueue(int capacity) {
    buffer = new byte[capacity];
  }

  int size() {
    return size;
  }

  void clear() {
    first = 0;
    size = 0;
  }

  /** Adds bytes, all or none. */
  void push(byte[] bytes, int offset, int length) {
    if (size + length > buffer.length) {
      return;
    }
    int end = (first + size) % buffer.length;
    int beforeWrap = Math.min(length, buffer.length - end);
    System.arraycopy(bytes, offset, buffer, end, beforeWrap);
    System.arraycopy(bytes, offset + beforeWrap, buffer, 0, length - beforeWrap);
    size += length;
  }

  /** Adds bytes given as numbers, all or none. */
  void push(int... octets) {
    byte[] bytes = new byte[octets.length];
    for (int i = 0; i < octets.length; i++) {
      bytes[i] = (byte) octets[i];
    }
    push(bytes, 0, bytes.length);
  }

  /** Removes up to the given number of bytes; returns the number removed. */
  int pull(byte[] target, int atMost) {
    int count = Math.min(atMost, size);
    int beforeWrap = Math.min(count, buffer.length - first);
    System.arraycopy(buffer, first, target, 0, beforeWrap);
    System.arraycopy(buffer, 0, target, beforeWrap, count - beforeWrap);
    first = (first + count) % buffer.length;
    size -= count;
    return count;
  }
}
