package org.u2sa.control.cascade;

import org.u2sa.messages.frame.Point;

/**
 * Drift angle of a vehicle that cannot move sideways: from its bow to its course over ground,
 * smoothed. The bow turned by as much to the other side, wind and current lead it along the wanted
 * course (Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control, 2nd ed., section
 * 12.4). Not thread-safe.
 */
final class Drift {
  private static final double TIME_S = 2.5; // longer than the bow takes to follow
  private static final double STEADY_RADPS = 0.15; // in faster turns the hull slips by itself
  private static final double SLOWEST_MPS = 0.3; // below, the course says nothing
  private static final double MAX_RAD = Math.toRadians(50.0);

  private double angleRad;

  /**
   * Updates the angle.
   *
   * @param velocity over ground: forward, right, down [m/s]
   * @param turnRadps turn rate
   */
  void step(Point velocity, double turnRadps, double stepS) {
    double now = Math.atan2(velocity.y(), Math.max(SLOWEST_MPS, velocity.x()));
    double turn = turnRadps / STEADY_RADPS;
    double share = Math.min(1.0, stepS / (TIME_S * (1.0 + turn * turn)));
    angleRad += share * (Math.max(-MAX_RAD, Math.min(MAX_RAD, now)) - angleRad);
  }

  /** The angle, positive if the vehicle drifts to the right [rad]. */
  double rad() {
    return angleRad;
  }
}
