package org.u2sa.control.cascade;

import org.u2sa.messages.frame.Point;

/**
 * Angle between a vehicle's bow and its course over ground, smoothed: the crab angle that cancels
 * wind and current (Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control, 2nd ed.,
 * section 12.4). Not thread-safe.
 */
final class DriftAngle {
  private static final double TIME_S = 6.0; // slower than the turns, which make the hull slip too
  private static final double SLOWEST_MPS = 0.3; // below, the course says nothing
  private static final double MAX_RAD = Math.toRadians(50.0);

  private double rad;

  /**
   * Updates the angle.
   *
   * @param velocity over ground: forward, right, down [m/s]
   */
  void step(Point velocity, double stepS) {
    double now =
        velocity.x() > 0.0 && Math.hypot(velocity.x(), velocity.y()) > SLOWEST_MPS
            ? Math.atan2(velocity.y(), velocity.x())
            : 0.0;
    double share = Math.min(1.0, stepS / TIME_S);
    rad += share * (Math.max(-MAX_RAD, Math.min(MAX_RAD, now)) - rad);
  }

  /** The angle, positive if the vehicle drifts to the right [rad]. */
  double rad() {
    return rad;
  }
}
