package org.u2sa.core.planning.local;

import org.u2sa.core.planning.curve.Pose;

/**
 * How a vehicle may move along its route. Immutable.
 *
 * @param speedMps wanted [m/s]
 * @param accelerationMps2 [m/s²]
 * @param brakingMps2 [m/s²]
 * @param turnRadiusM of its tightest turn at that speed [m]; 0 if it turns on the spot
 * @param stops whether it can stand: an aeroplane cannot
 * @param reverses whether it can go backwards
 * @param lookAheadM how far ahead on the route it is led [m]
 * @param touchM nearer to an obstacle than this counts as a collision [m]
 * @param preferredM to be kept from obstacles where the route does [m]; 0: touchM is enough
 * @param trafficM to be kept from traffic beyond both radii [m]
 * @param horizonS how far ahead in time traffic is looked at [s]
 * @param reactionS time until an order takes effect [s]
 * @param turnRateRadPerS of a turn on the spot [rad/s], above 0
 */
public record MotionLimits(
    double speedMps,
    double accelerationMps2,
    double brakingMps2,
    double turnRadiusM,
    boolean stops,
    boolean reverses,
    double lookAheadM,
    double touchM,
    double preferredM,
    double trafficM,
    double horizonS,
    double reactionS,
    double turnRateRadPerS) {
  /** A vehicle that turns on the spot drives arcs to points this near to straight ahead [rad]. */
  static final double SPOT_TURN_RAD = Math.toRadians(30.0);

  /** Whether it turns on the spot. */
  boolean turnsOnTheSpot() {
    return turnRadiusM == 0.0;
  }

  /** The tightest arc on which it is led [1/m]. */
  double tightest() {
    return turnsOnTheSpot() ? 2.0 * Math.sin(SPOT_TURN_RAD) / lookAheadM : 1.0 / turnRadiusM;
  }

  /**
   * Of the arc to a point, tangent to the heading [1/m], to the right positive, and no tighter than
   * {@link #tightest()} (Coulter, CMU-RI-TR-92-01: 2 y / L²).
   */
  double curvatureTo(Pose from, double north, double east, boolean backwards) {
    double dn = north - from.northM();
    double de = east - from.eastM();
    double right = de * Math.cos(from.headingRad()) - dn * Math.sin(from.headingRad());
    double ahead = dn * Math.cos(from.headingRad()) + de * Math.sin(from.headingRad());
    double square = dn * dn + de * de;
    if (square < 1.0e-6) {
      return 0.0;
    }
    boolean wrongSide = backwards ? ahead > 0.0 : ahead < 0.0;
    double wanted = wrongSide ? Math.copySign(tightest(), right) : 2.0 * right / square;
    return Math.max(-tightest(), Math.min(tightest(), wanted));
  }

  /**
   * The speed from which it stops within a way [m/s]; 0 if it is too late.
   *
   * @param wayM up to what is in the way, less what is to be kept; infinite if nothing is
   */
  double stoppableMps(double wayM) {
    if (wayM == Double.POSITIVE_INFINITY) {
      return speedMps;
    }
    if (wayM <= 0.0) {
      return 0.0;
    }
    double b = brakingMps2 * reactionS; // v²/2b + v t = left
    return Math.min(speedMps, Math.sqrt(b * b + 2.0 * brakingMps2 * wayM) - b);
  }

  /** Way to stop from a speed, reaction included [m]. */
  double stoppingM(double fromMps) {
    return fromMps * fromMps / (2.0 * brakingMps2) + fromMps * reactionS;
  }

  /**
   * How far aside it comes to stand if it turns at its rate w while it brakes: the integral of (v −
   * b t) w t, w v³/6b², here of the whole way to stand [m].
   */
  double slipM(double fromMps) {
    return stoppingM(fromMps) * turnRateRadPerS * fromMps / brakingMps2 / 3.0;
  }
}
