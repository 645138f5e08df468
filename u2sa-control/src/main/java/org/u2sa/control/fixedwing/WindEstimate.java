package org.u2sa.control.fixedwing;

import org.u2sa.control.Transfer;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;

/**
 * Estimates the wind: velocity over ground minus velocity through the air, with gusts averaged out.
 */
final class WindEstimate {
  private static final double TIME_CONSTANT_S = 10.0;
  private static final double SETTLING_S = 0.05; // the first readings are averaged evenly
  private static final double KNOWN_S = 5.0; // averaged for so long, it is not a gust

  private double northMps;
  private double eastMps;
  private double knownS; // time averaged so far

  /** Adds a state to the average, if its velocity over ground is known. */
  void step(FlightState state, double dtS) {
    if (!state.overGroundKnown()) {
      return;
    }
    double cosBeta = StrictMath.cos(state.betaRad());
    Point air =
        Rotation.nedFromFrd(state.rollRad(), state.pitchRad(), state.headingRad())
            .times(
                Point.of(
                    state.trueAirspeedMps() * cosBeta * StrictMath.cos(state.alphaRad()),
                    state.trueAirspeedMps() * StrictMath.sin(state.betaRad()),
                    state.trueAirspeedMps() * cosBeta * StrictMath.sin(state.alphaRad())));
    knownS = Math.min(TIME_CONSTANT_S, knownS + dtS);
    double share = Math.min(1.0, dtS / Math.max(SETTLING_S, knownS));
    northMps += share * (state.northMps() - air.x() - northMps);
    eastMps += share * (state.eastMps() - air.y() - eastMps);
  }

  /** Wind speed [m/s]. */
  double speedMps() {
    return StrictMath.hypot(northMps, eastMps);
  }

  /** Crosswind component on a course, positive if blowing to the right [m/s]. */
  double acrossMps(double courseRad) {
    return eastMps * StrictMath.cos(courseRad) - northMps * StrictMath.sin(courseRad);
  }

  /** Wind component along a course, positive if from behind [m/s]. */
  private double alongMps(double courseRad) {
    return northMps * StrictMath.cos(courseRad) + eastMps * StrictMath.sin(courseRad);
  }

  /**
   * True airspeed with which a ground speed is attained on a course [m/s]: the wind triangle. 0 if
   * the wind alone is faster along the course, or is not known yet.
   */
  double airspeedMps(double courseRad, double groundSpeedMps) {
    if (knownS < KNOWN_S) {
      return 0.0;
    }
    double along = Math.max(0.0, groundSpeedMps - alongMps(courseRad));
    return StrictMath.hypot(along, acrossMps(courseRad));
  }

  /**
   * Ground speed that is possible on a course with a true airspeed [m/s]; negative if the wind
   * drives the aircraft back, or off a course that it cannot hold.
   */
  double headwayMps(double courseRad, double airspeedMps) {
    double across = Math.abs(acrossMps(courseRad));
    return across < airspeedMps
        ? StrictMath.sqrt(airspeedMps * airspeedMps - across * across) + alongMps(courseRad)
        : airspeedMps - speedMps();
  }

  /**
   * Heading on which an aircraft makes good a course, or against the wind if it cannot [rad].
   *
   * @param airspeedMps true airspeed, above 0
   */
  double headingRad(double courseRad, double airspeedMps) {
    return headwayMps(courseRad, airspeedMps) > 0.0
        ? courseRad - StrictMath.asin(Limit.symmetric(acrossMps(courseRad) / airspeedMps, 1.0))
        : StrictMath.atan2(-eastMps, -northMps);
  }

  void transfer(Transfer state) {
    northMps = state.number("WIND NORTH", northMps);
    eastMps = state.number("WIND EAST", eastMps);
    knownS = state.number("WIND KNOWN FOR", knownS);
  }
}
