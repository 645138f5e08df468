package org.u2sa.planning.guidance;

import org.u2sa.interfaces.time.Clock;

/** Monitors whether a vehicle approaches an altitude. Confined to the planner's thread. */
public final class AltitudeProgress {
  private static final double STEP_M = 0.05; // a smaller change is an estimation error
  private static final long PATIENCE_MICROS = 5 * Clock.MICROS_PER_SECOND;

  private double leastM = Double.POSITIVE_INFINITY;
  private long cameNearerMicros;

  /** Starts with a new altitude. */
  public void begin() {
    leastM = Double.POSITIVE_INFINITY;
  }

  /**
   * Whether it has come closer within the last seconds.
   *
   * @param offM distance from the altitude [m], not negative
   */
  public boolean comesNearer(double offM, long nowMicros) {
    if (offM < leastM - STEP_M) {
      leastM = offM;
      cameNearerMicros = nowMicros;
    }
    return nowMicros - cameNearerMicros < PATIENCE_MICROS;
  }
}
