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
    for (int i = 0; i < length; i++) {
      buffer[(first + size++) % buffer.length] = bytes[offset + i];
    }
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
    for (int i = 0; i < count; i++) {
      target[i] = buffer[first];
      first = (first + 1) % buffer.length;
    }
    size -= count;
    return count;
  }
}
