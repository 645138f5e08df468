package org.u2sa.core.communication;

import java.util.concurrent.atomic.AtomicLong;

/**
 * Messages that are inside Moquette. Its queues silently drop what does not fit; so clients are
 * read more slowly before that, and messages that stay inside count as lost. Safe for several
 * threads.
 */
final class Backlog {
  private final AtomicLong in = new AtomicLong();
  private final AtomicLong out = new AtomicLong();
  private final AtomicLong lost = new AtomicLong();
  private final AtomicLong kept = new AtomicLong();
  private final AtomicLong bytesInside = new AtomicLong();
  private long inBefore; // guarded by this
  private long outBefore; // guarded by this

  void in(int bytes) {
    in.incrementAndGet();
    bytesInside.addAndGet(bytes);
  }

  void out(int bytes) {
    out.incrementAndGet();
    bytesInside.addAndGet(-bytes);
  }

  /** Takes note of a message that is kept until each of its subscribers has acknowledged it. */
  void keep(int bytes) {
    kept.addAndGet(bytes);
  }

  /** Bytes of {@link #keep}, so far. */
  long kept() {
    return kept.get();
  }

  boolean isFull() {
    return in.get() - out.get() - lost.get() >= BrokerLimits.ON_THE_WAY
        || bytesInside.get() >= BrokerLimits.BYTES_ON_THE_WAY;
  }

  /**
   * Called about once a second: if nothing moved since the last call, what is inside is lost.
   *
   * @return how many were found lost
   */
  synchronized long settle() {
    long inNow = in.get();
    long outNow = out.get();
    boolean moved = inNow != inBefore || outNow != outBefore;
    inBefore = inNow;
    outBefore = outNow;
    long inside = inNow - outNow - lost.get();
    if (moved) {
      return 0;
    }
    bytesInside.set(0); // what is still inside will not come out, or nothing is
    if (inside == 0) {
      return 0;
    }
    lost.addAndGet(inside); // negative if Moquette published by itself, as it does wills
    return Math.max(0, inside);
  }
}
