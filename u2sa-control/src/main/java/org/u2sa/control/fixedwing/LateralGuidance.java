package org.u2sa.control.fixedwing;

import org.u2sa.messages.frame.Gravity;

/**
 * Steers to a point ahead on the leg: S. Park, J. Deyst, J. P. How, A New Nonlinear Guidance Logic
 * for Trajectory Tracking, AIAA 2004-4900, eq. 1: a = 2 V² / L1 · sin η, with ground speed V, so
 * that no wind estimate is needed. Bank is that of a level coordinated turn.
 */
final class LateralGuidance {

  private static final double SLOWEST_MPS = 5.0; // ground speed; below it the track is meaningless

  private final double shortestM;

  /**
   * @param shortestM minimum L1 [m]: nearer points count as this far, to bound the gain
   */
  LateralGuidance(double shortestM) {
    this.shortestM = shortestM;
  }

  /**
   * Lateral acceleration over ground towards the point [m/s², right positive].
   *
   * @param northM north of the point from the aircraft [m]
   */
  double accelerationMps2(FlightState state, double northM, double eastM) {
    double speed = state.groundSpeedMps();
    double distance = Math.max(shortestM, StrictMath.hypot(northM, eastM));
    double track =
        speed < SLOWEST_MPS
            ? state.headingRad()
            : StrictMath.atan2(state.eastMps(), state.northMps());
    double eta = Limit.angle(StrictMath.atan2(eastM, northM) - track);
    // The paper limits η to a right angle, beyond which the sine would fall again.
    double bounded = Limit.symmetric(eta, Math.PI / 2.0);
    return 2.0 * speed * speed / distance * StrictMath.sin(bounded);
  }

  /** Bank of the coordinated level turn to the point [rad, right wing down positive], unlimited. */
  double bankRad(FlightState state, double northM, double eastM) {
    return StrictMath.atan2(accelerationMps2(state, northM, eastM), Gravity.STANDARD_MPS2);
  }
}
