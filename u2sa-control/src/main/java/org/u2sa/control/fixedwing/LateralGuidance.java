package org.u2sa.control.fixedwing;

import org.u2sa.messages.frame.Gravity;

/**
 * Steers to a point ahead on the leg: S. Park, J. Deyst, J. P. How, A New Nonlinear Guidance Logic
 * for Trajectory Tracking, AIAA 2004-4900, eq. 1: a = 2 V² / L1 · sin η, with ground speed V, so
 * that no wind estimate is needed. Bank is that of a level coordinated turn.
 */
final class LateralGuidance {

  private static final double SLOWEST_MPS = 5.0; // ground speed; below it the track is meaningless
  private static final double CREEPS_MPS = 2.0; // ground speed; below it only the heading counts
  private static final double HEADWAY_MPS = 4.0; // attainable; above it only the track counts
  private static final double WINDY = 0.5; // wind speed as a fraction of airspeed
  private static final double STORMY = 0.75; // above it only speed made good counts
  private static final double HEADING_S = 4.0; // twice the time constant of a turn to a heading

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

  /**
   * Lateral acceleration that turns the nose to a heading, for winds in which the aircraft makes
   * little or no headway and its track is no guide [m/s², right positive].
   *
   * @param headingRad heading to turn to
   */
  double headingAccelerationMps2(FlightState state, double headingRad) {
    double error = Limit.symmetric(Limit.angle(headingRad - state.headingRad()), Math.PI / 2.0);
    double speed = state.trueAirspeedMps();
    double distance = Math.max(shortestM, HEADING_S * speed);
    return 2.0 * speed * speed / distance * StrictMath.sin(error);
  }

  /**
   * Bank to the point [rad, right wing down positive], unlimited, against a wind that may be as
   * fast as the aircraft. The less headway it makes or can make, the more it steers by heading
   * instead of track. In a wind above half the airspeed, headway means speed made good towards the
   * point, because a track that leads away from the point turns slowly.
   */
  double bankRad(FlightState state, double northM, double eastM, WindEstimate wind) {
    double course = StrictMath.atan2(eastM, northM);
    double speed = Math.max(SLOWEST_MPS, state.trueAirspeedMps());
    double possible = wind.headwayMps(course, speed) / HEADWAY_MPS;
    double strong = Limit.within(0.0, (wind.speedMps() / speed - WINDY) / (STORMY - WINDY), 1.0);
    double advance =
        state.northMps() * StrictMath.cos(course) + state.eastMps() * StrictMath.sin(course);
    double madeMps = state.groundSpeedMps() + strong * (advance - state.groundSpeedMps());
    double made = (madeMps - CREEPS_MPS) / (SLOWEST_MPS - CREEPS_MPS);
    double share = Limit.within(0.0, Math.min(possible, made), 1.0);
    double byTrack = accelerationMps2(state, northM, eastM);
    if (share == 1.0) {
      return StrictMath.atan2(byTrack, Gravity.STANDARD_MPS2);
    }
    double byHeading = headingAccelerationMps2(state, wind.headingRad(course, speed));
    return StrictMath.atan2(share * byTrack + (1.0 - share) * byHeading, Gravity.STANDARD_MPS2);
  }

  /** Bank of the coordinated level turn to the point [rad, right wing down positive], unlimited. */
  double bankRad(FlightState state, double northM, double eastM) {
    return StrictMath.atan2(accelerationMps2(state, northM, eastM), Gravity.STANDARD_MPS2);
  }
}
