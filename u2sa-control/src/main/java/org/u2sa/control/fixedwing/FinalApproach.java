package org.u2sa.control.fixedwing;

import org.u2sa.control.Transfer;

/**
 * Estimates the line that navigation follows from its points ahead, independent of the aircraft's
 * position. In the flare it serves as the runway's centreline.
 */
final class FinalApproach {
  private static final double TIME_CONSTANT_S =
      5.0; // at 38 m/s this measures the direction over 190 m
  private static final double SHORTEST_M = 50.0; // nearer points give no direction

  private double northM; // last point
  private double eastM;
  private double laggedNorthM;
  private double laggedEastM;
  private boolean seen;

  /** Records a navigation point. */
  void see(FlightState state, GuidanceTarget target, double dtS) {
    northM = state.northM() + target.northM();
    eastM = state.eastM() + target.eastM();
    if (!seen) {
      laggedNorthM = northM;
      laggedEastM = eastM;
      seen = true;
    }
    double share = dtS / (TIME_CONSTANT_S + dtS);
    laggedNorthM += share * (northM - laggedNorthM);
    laggedEastM += share * (eastM - laggedEastM);
  }

  /** Whether navigation has followed a line long enough to know its direction. */
  boolean isKnown() {
    return seen && StrictMath.hypot(northM - laggedNorthM, eastM - laggedEastM) > SHORTEST_M;
  }

  /** Direction of the line [rad, clockwise from north]. */
  double courseRad() {
    return StrictMath.atan2(eastM - laggedEastM, northM - laggedNorthM);
  }

  /** A point on the line, in the frame of the aircraft's position: north [m]. */
  double northM() {
    return northM;
  }

  /** The same point: east [m]. */
  double eastM() {
    return eastM;
  }

  void transfer(Transfer state) {
    seen = state.has("FINAL NORTH", seen);
    if (seen) {
      northM = state.number("FINAL NORTH", northM);
      eastM = state.number("FINAL EAST", eastM);
      laggedNorthM = state.number("FINAL LAGGED NORTH", laggedNorthM);
      laggedEastM = state.number("FINAL LAGGED EAST", laggedEastM);
    }
  }
}
