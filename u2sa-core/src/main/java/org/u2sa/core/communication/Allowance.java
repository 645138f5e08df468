package org.u2sa.core.communication;

import org.u2sa.interfaces.Clock;

/** So much a second, and up to a quarter of a second's worth at once. For one thread. */
final class Allowance {
  private static final double BURST_S = 0.25;

  private final double perS;
  private double left;
  private long asOfMicros;

  Allowance(double perS, long nowMicros) {
    this.perS = perS;
    left = perS * BURST_S;
    asOfMicros = nowMicros;
  }

  /** Whether anything is left; one may overdraw it once. */
  boolean isOpen(long nowMicros) {
    left = Math.min(perS * BURST_S, left + perS * Clock.seconds(nowMicros - asOfMicros));
    asOfMicros = nowMicros;
    return left > 0.0;
  }

  void take(double amount) {
    left -= amount;
  }
}
