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

  private double northMps;
  private double eastMps;
  private double knownS; // time averaged so far

  /** Adds a state to the average. */
  void step(FlightState state, double dtS) {
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

  void transfer(Transfer state) {
    northMps = state.number("WIND NORTH", northMps);
    eastMps = state.number("WIND EAST", eastMps);
    knownS = state.number("WIND KNOWN FOR", knownS);
  }
}
