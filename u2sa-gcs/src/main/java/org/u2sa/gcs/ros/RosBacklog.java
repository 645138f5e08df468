package org.u2sa.gcs.ros;

import java.util.concurrent.atomic.AtomicLong;

/**
 * Limits the total size of one client's queues in characters of JSON, because a queue may hold maps
 * of megabytes for as long as the client requests. Thread-safe.
 */
final class RosBacklog {
  private static final long LARGEST = 4L << 20;
  private static final long HEAP_PART = 128; // 16 clients together an eighth

  private final long most;
  private final AtomicLong held = new AtomicLong();

  RosBacklog(long most) {
    this.most = most;
  }

  /** The limit for one of 16 clients on this heap. */
  static RosBacklog ofClient() {
    return new RosBacklog(Math.min(LARGEST, Runtime.getRuntime().maxMemory() / HEAP_PART));
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
