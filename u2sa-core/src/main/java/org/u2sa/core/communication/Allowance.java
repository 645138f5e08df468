package org.u2sa.core.communication;

import org.u2sa.interfaces.time.Clock;

/** So much a second, and up to a quarter of a second's worth at once. For one thread. */
final class Allowance {
  private static final double BURST_S = 0.25;
  private static final double LEAST_BURST = 1.0; // of a slow one, too, at least one goes at once

  private final double perS;
  private final double burst;
  private double left;
  private long asOfMicros;

  Allowance(double perS, long nowMicros) {
    this.perS = perS;
    burst = Math.max(LEAST_BURST, perS * BURST_S);
    left = burst;
    asOfMicros = nowMicros;
  }

  /** Whether anything is left; one may overdraw it once. */
  boolean isOpen(long nowMicros) {
    left = Math.min(burst, left + perS * Clock.seconds(nowMicros - asOfMicros));
    asOfMicros = nowMicros;
    return left > 0.0;
  }

  void take(double amount) {
    left -= amount;
  }
}
