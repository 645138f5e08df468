package org.u2sa.core.control.ground;

/**
 * What motors must be told more while a motion changes. At a constant command, inertia has a
 * vehicle take up a new speed as a first-order lag does, T dv/dt + v = told, so it is told the
 * speed and T times its rate of change. Belongs to one thread.
 */
final class PickUp {
  /** A rate of change is taken over so long: the wanted motion jumps a little with each state. */
  private static final double SMOOTHED_S = 0.1;

  private double smooth = Double.NaN; // not before the first step: it may take over while moving

  /**
   * What to add to a wanted speed, or yaw rate.
   *
   * @param timeS T, in which the vehicle takes up 63 % of a step [s]; 0: nothing is added
   */
  double step(double wanted, double timeS, double stepS) {
    if (Double.isNaN(smooth)) {
      smooth = wanted;
    }
    smooth += stepS / (SMOOTHED_S + stepS) * (wanted - smooth);
    return timeS * (wanted - smooth) / SMOOTHED_S;
  }
}
