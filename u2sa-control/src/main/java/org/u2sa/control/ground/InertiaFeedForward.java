package org.u2sa.control.ground;

/**
 * Feed-forward that compensates inertia. At a constant command, the vehicle approaches a new speed
 * as a first-order lag, T dv/dt + v = command, so the command is the speed plus T times its rate of
 * change. Not thread-safe.
 */
final class InertiaFeedForward {
  /** Filter time of the rate of change; the wanted motion jumps slightly with each state. */
  private static final double SMOOTHED_S = 0.1;

  private double smooth = Double.NaN; // NaN before the first step, which may be on the move

  /** Starts from a steady speed or yaw rate. */
  void startFrom(double steady) {
    smooth = steady;
  }

  /**
   * Computes the addition to a wanted speed or yaw rate.
   *
   * @param timeS time constant T, in which the vehicle reaches 63 % of a step [s]; 0 adds nothing
   */
  double step(double wanted, double timeS, double stepS) {
    if (Double.isNaN(smooth)) {
      smooth = wanted;
    }
    smooth += stepS / (SMOOTHED_S + stepS) * (wanted - smooth);
    return timeS * (wanted - smooth) / SMOOTHED_S;
  }
}
