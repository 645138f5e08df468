package org.u2sa.interfaces.communication;

import java.util.Random;

/**
 * How long to wait before the next attempt to connect: longer after each failure, and never the
 * same for all, so that the services of a vehicle do not fall upon a restarted broker together.
 */
final class BackOff {
  private static final long FIRST_MS = 100;
  private static final long LONGEST_MS = 2_000;
  private static final double LEAST_PART = 0.5;

  private final Random random;
  private long nextMs = FIRST_MS;

  BackOff(Random random) {
    this.random = random;
  }

  /**
   * The wait before the next attempt [ms]: between half and the whole of what doubles each time.
   */
  synchronized long nextMs() {
    long whole = nextMs;
    nextMs = Math.min(LONGEST_MS, 2 * nextMs);
    return Math.round(whole * (LEAST_PART + (1 - LEAST_PART) * random.nextDouble()));
  }

  /** Begins again with the shortest wait, after success. */
  synchronized void reset() {
    nextMs = FIRST_MS;
  }
}
