package org.u2sa.control.cascade;

import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Gravity;

/**
 * Sideways motion of a vehicle whose actuators only produce lift: it tilts and increases its lift.
 * In axes of the levelled vehicle: forward, right, down. Not thread-safe.
 */
final class Lean {
  private static final double G = Gravity.STANDARD_MPS2;
  private static final double MIN_UPRIGHT =
      0.5; // fraction of the lift assumed available at large tilt

  private double forward;
  private double right;

  /**
   * Computes the tilt angles for an acceleration; if it exceeds the limit, its direction is kept.
   *
   * @param forwardMps2 wanted acceleration [m/s²]
   * @param rightMps2 wanted acceleration [m/s²]
   * @param maxRad maximum angle from the vertical [rad]
   */
  void towards(double forwardMps2, double rightMps2, double maxRad) {
    double most = G * StrictMath.tan(maxRad);
    double wanted = Math.hypot(forwardMps2, rightMps2);
    double share = wanted > most ? most / wanted : 1.0;
    forward = share * forwardMps2;
    right = share * rightMps2;
  }

  /** Pitch to lean by, nose up positive [rad]. */
  double pitchRad() {
    return -StrictMath.atan(forward / G);
  }

  /** Roll to lean by, right side down positive [rad]. */
  double rollRad() {
    return StrictMath.atan(right * StrictMath.cos(pitchRad()) / G);
  }

  /** Acceleration that the angles give: forward [m/s²]. */
  double forward() {
    return forward;
  }

  /** Acceleration that the angles give: to the right [m/s²]. */
  double right() {
    return right;
  }

  /**
   * Force per mass along the vehicle's down axis that gives a vertical acceleration against gravity
   * [m/s²].
   */
  static double lift(double downMps2, Attitude attitude) {
    return (downMps2 - G) / upright(attitude);
  }

  /** Vertical acceleration that a force per mass gives: the inverse of {@link #lift}. */
  static double down(double lift, Attitude attitude) {
    return lift * upright(attitude) + G;
  }

  private static double upright(Attitude attitude) {
    double cos = StrictMath.cos(attitude.phi()) * StrictMath.cos(attitude.theta());
    return Math.max(MIN_UPRIGHT, cos);
  }
}
