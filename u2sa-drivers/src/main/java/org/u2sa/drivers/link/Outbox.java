package org.u2sa.drivers.link;

import java.util.ArrayDeque;
import java.util.Deque;

/** Bounded queue of outgoing data. Not thread-safe. */
final class Outbox {
  private final int capacity;
  private final Deque<byte[]> waiting = new ArrayDeque<>();
  private int count;

  /**
   * @param capacity maximum number of queued bytes
   */
  Outbox(int capacity) {
    this.capacity = capacity;
  }

  /** Queues a copy if it fits; returns whether it did. */
  boolean put(byte[] bytes) {
    if (count + bytes.length > capacity) {
      return false;
    }
    waiting.add(bytes.clone());
    count += bytes.length;
    return true;
  }

  boolean isEmpty() {
    return waiting.isEmpty();
  }

  /** Removes the oldest entry. */
  byte[] take() {
    byte[] next = waiting.remove();
    count -= next.length;
    return next;
  }

  void clear() {
    waiting.clear();
    count = 0;
  }
}
