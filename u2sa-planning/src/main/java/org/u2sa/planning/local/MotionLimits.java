package org.u2sa.planning.local;

import org.u2sa.planning.curve.Pose;

/**
 * Limits of a vehicle's motion along its route. Immutable.
 *
 * @param speedMps wanted speed [m/s]
 * @param accelerationMps2 [m/s²]
 * @param brakingMps2 [m/s²]
 * @param turnRadiusM minimum turn radius at that speed [m]; 0 if it turns in place
 * @param stops whether it can stop, unlike an aeroplane
 * @param backwardsMps maximum speed in reverse [m/s]; 0 if it cannot reverse
 * @param lookAheadM look-ahead on the route [m]
 * @param touchM collision distance to an obstacle [m]
 * @param preferredM distance to keep from obstacles wherever the route keeps it [m]; 0 if touchM
 *     suffices
 * @param trafficM distance to keep from traffic beyond both radii [m]
 * @param horizonS time horizon of traffic prediction [s]
 * @param reactionS delay until a command takes effect [s]
 * @param turnRateRadPerS yaw rate of turns in place [rad/s], above 0
 * @param clearanceM distance that routes keep from obstacles [m]
 */
public record MotionLimits(
    double speedMps,
    double accelerationMps2,
    double brakingMps2,
    double turnRadiusM,
    boolean stops,
    double backwardsMps,
    double lookAheadM,
    double touchM,
    double preferredM,
    double trafficM,
    double horizonS,
    double reactionS,
    double turnRateRadPerS,
    double clearanceM) {
  /** Bearing up to which a vehicle that turns in place drives arcs [rad]. */
  static final double SPOT_TURN_RAD = Math.toRadians(30.0);

  boolean reverses() {
    return backwardsMps > 0.0;
  }

  /** Maximum speed forwards or in reverse [m/s]. */
  double mps(boolean backwards) {
    return backwards ? Math.min(speedMps, backwardsMps) : speedMps;
  }

  boolean turnsOnTheSpot() {
    return turnRadiusM == 0.0;
  }

  /** Maximum curvature [1/m]. */
  double tightest() {
    return turnsOnTheSpot() ? 2.0 * Math.sin(SPOT_TURN_RAD) / lookAheadM : 1.0 / turnRadiusM;
  }

  /**
   * Curvature of the arc to a point, tangent to the heading [1/m], right positive, and no tighter
   * than {@link #tightest()}.
   */
  double curvatureTo(Pose from, double north, double east, boolean backwards) {
    return from.curvatureTo(north, east, tightest(), backwards);
  }

  /**
   * Maximum speed from which it stops within a distance [m/s]; 0 if it is too late.
   *
   * @param wayM distance to the obstacle less the clearance; infinite if none
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

  /** Stopping distance from a speed, including reaction [m]. */
  double stoppingM(double fromMps) {
    return fromMps * fromMps / (2.0 * brakingMps2) + fromMps * reactionS;
  }

  /**
   * Sideways drift if it turns at its rate w while braking: the integral of (v − b t) w t, w
   * v³/6b², here over the whole stopping distance [m].
   */
  double slipM(double fromMps) {
    return stoppingM(fromMps) * turnRateRadPerS * fromMps / brakingMps2 / 3.0;
  }
}
