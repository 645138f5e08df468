package org.u2sa.gcs.ros;

import java.util.concurrent.atomic.AtomicLong;

/**
 * Limits what waits for one client, or of it, in characters of JSON: a queue may hold maps of
 * megabytes for as long as the client requests, and operations wait while earlier ones are slow.
 * Thread-safe.
 */
final class RosBacklog {
  private static final long LARGEST = 4L << 20;
  private static final long OUTGOING_PART = 128; // 16 clients together an eighth of the heap
  private static final long INCOMING_PART = 256;

  private final long most;
  private final AtomicLong held = new AtomicLong();

  RosBacklog(long most) {
    this.most = most;
  }

  /** The limit of messages for one of 16 clients on this heap. */
  static RosBacklog outgoing() {
    return ofHeap(OUTGOING_PART);
  }

  /** The limit of operations of one of 16 clients on this heap. */
  static RosBacklog incoming() {
    return ofHeap(INCOMING_PART);
  }

  private static RosBacklog ofHeap(long part) {
    return new RosBacklog(Math.min(LARGEST, Runtime.getRuntime().maxMemory() / part));
  }

  /** Reserves this many characters; false if there is no room. */
  boolean hold(int length) {
    boolean fits = held.addAndGet(length) <= most;
    if (!fits) {
      held.addAndGet(-length);
    }
    return fits;
  }

  void free(int length) {
    held.addAndGet(-length);
  }
}
