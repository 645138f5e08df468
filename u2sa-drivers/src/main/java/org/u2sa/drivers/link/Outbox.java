package org.u2sa.drivers.link;

import java.util.ArrayDeque;
import java.util.Deque;

/** What waits to be sent, up to a limit. Not safe for several threads. */
final class Outbox {
  private final int capacity;
  private final Deque<byte[]> waiting = new ArrayDeque<>();
  private int count;

  /**
   * @param capacity most bytes that wait
   */
  Outbox(int capacity) {
    this.capacity = capacity;
  }

  /** Takes a copy of all, or nothing; returns whether. */
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

  /** The oldest. */
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
