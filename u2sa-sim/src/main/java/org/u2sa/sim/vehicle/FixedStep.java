package org.u2sa.sim.vehicle;

/** Splits steps of any length into fixed-length ticks. Not thread-safe. */
public final class FixedStep {
  /** Longest step accepted by {@link SimulatedVehicle#step} [s]. */
  static final double LONGEST_STEP_S = 60.0;

  private static final double ROUNDING = 1e-6; // relative to a tick

  private final int ticksPerSecond;
  private long ticks;
  private double dueS;

  /**
   * @param ticksPerSecond internal integration rate [1/s]
   */
  public FixedStep(int ticksPerSecond) {
    this.ticksPerSecond = ticksPerSecond;
  }

  /**
   * Runs the ticks of a step; the remainder carries over to the next step.
   *
   * @throws IllegalArgumentException if dt is not above 0 and at most 60 s
   */
  public void step(double dtS, Runnable tick) {
    if (!(dtS > 0.0 && dtS <= LONGEST_STEP_S)) {
      throw new IllegalArgumentException("dt: " + dtS + " s is outside 0…" + LONGEST_STEP_S + " s");
    }
    dueS += dtS;
    long count = (long) StrictMath.floor(dueS * ticksPerSecond + ROUNDING);
    dueS -= (double) count / ticksPerSecond;
    for (long i = 0; i < count; i++) {
      ticks++;
      tick.run();
    }
  }

  /** Time since the start [s]. */
  public double timeS() {
    return (double) ticks / ticksPerSecond;
  }
}
