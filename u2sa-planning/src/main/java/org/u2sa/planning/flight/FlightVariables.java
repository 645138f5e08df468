package org.u2sa.planning.flight;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Variables of take-off, landing and drops. */
public record FlightVariables(
    @Variable(unit = "m", min = 0, max = 100, ifAbsent = 0)
        @Description(
            "Altitude difference within which a take-off without verticalThreshold is completed. 0: 3 m for an aeroplane, 0.5 m for a multirotor.")
        double takeOffAccuracy,
    @Variable(unit = "m", min = 10, max = 10000, ifAbsent = 600)
        @Description("Length of the straight descent if a landing does not specify it.")
        double approachLength,
    @Variable(unit = "deg", min = 1, max = 45, ifAbsent = 5)
        @Description("Angle of the descent if a landing does not specify it.")
        double approachSlope,
    @Variable(unit = "m", min = 1, max = 200, ifAbsent = 15)
        @Description(
            "Cross-track and altitude error at the start of the descent above which the approach is repeated.")
        double approachAccuracy,
    @Variable(unit = "m", min = 0, max = 10000, ifAbsent = 40)
        @Description(
            "Minimum height above the take-off point at which an aeroplane (with TURN ACCELERATION and LOITER RADIUS) circles, or flies to goals without altitude. Below half of it, an aeroplane that holds or breaks off a take-off or landing climbs straight ahead first. 0: none.")
        double minHoldHeight,
    @Variable(unit = "s", min = 0, max = 3600, ifAbsent = 60)
        @Description(
            "Time without headway towards the navigation point, for example in a wind faster than the airspeed, after which an aeroplane abandons its goal, except on its way home. A warning is given after half of it. 0: not watched.")
        double headwayTime,
    @Variable(unit = "m/s", min = 0.1, max = 5, ifAbsent = 0.5)
        @Description("Sink rate at which a multirotor touches down.")
        double touchDownSink,
    @Variable(unit = "s", min = 0, max = 5, ifAbsent = 0.1)
        @Description("Delay from the decision to drop a payload until it falls.")
        double releaseDelay) {
  private static final double AEROPLANE_ACCURACY_M = 3.0;
  private static final double HOVER_ACCURACY_M = 0.5;

  /** {@link #takeOffAccuracy}, or its default for that kind of aircraft [m]. */
  public double takeOffAccuracyM(boolean isAeroplane) {
    double usualM = isAeroplane ? AEROPLANE_ACCURACY_M : HOVER_ACCURACY_M;
    return takeOffAccuracy > 0.0 ? takeOffAccuracy : usualM;
  }
}
