package org.u2sa.gcs.ros;

import java.util.concurrent.atomic.AtomicLong;

/**
 * Limits the messages waiting for one client, or its waiting operations, in characters of JSON: a
 * client may request long queues of maps of several megabytes, and operations wait behind slow
 * ones. Thread-safe.
 */
final class RosBacklog {
  private static final long LARGEST = 4L << 20;
  private static final long OUTGOING_PART = 128; // 16 clients may use an eighth of the heap
  private static final long INCOMING_PART = 256;

  private final long most;
  private final AtomicLong held = new AtomicLong();

  RosBacklog(long most) {
    this.most = most;
  }

  /** Limit of the messages for one client. */
  static RosBacklog outgoing() {
    return ofHeap(OUTGOING_PART);
  }

  /** Limit of the operations of one client. */
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
