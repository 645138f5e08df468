package org.u2sa.sim.ioio;

/**
 * A queue of bytes of fixed length. As the firmware's: what does not fit as a whole is dropped as a
 * whole, and nobody is told.
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

  /** Takes up to so many bytes out; returns how many. */
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
