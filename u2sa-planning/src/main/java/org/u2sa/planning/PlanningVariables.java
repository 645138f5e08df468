package org.u2sa.planning;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.LineSettings.AltitudeProfile;
import org.u2sa.planning.guidance.TurnAnticipation;

/**
 * Configuration variables of every {@link PathPlanner}. They alone distinguish an aircraft from a
 * ground vehicle.
 */
record PlanningVariables(
    @Variable(unit = "m/s^2", min = 0, ifAbsent = 0)
        @Description(
            "Lateral acceleration of turns: g tan(bank) for aircraft; 0 for a vehicle that turns in place.")
        double turnAcceleration,
    @Variable(unit = "s", min = 0, ifAbsent = 0)
        @Description(
            "Delay from the command to turn until the turn is established: an aircraft's roll-in.")
        double turnLag,
    @Variable(unit = "m", min = 0, ifAbsent = 60)
        @Description(
            "Maximum distance by which a turn may cut the corner at a waypoint, however large its threshold.")
        double cornerLimit,
    @Variable(unit = "m", min = 0, minExcluded = true, ifAbsent = 1)
        @Description(
            "Minimum look-ahead distance along the line. A shorter distance holds the line more tightly.")
        double lookAhead,
    @Variable(unit = "s", min = 0, ifAbsent = 1)
        @Description(
            "Look-ahead time: the target is at least the distance covered in this time ahead.")
        double lookAheadTime,
    @Variable(ifAbsentText = "IMMEDIATE")
        @Description(
            "IMMEDIATE changes immediately to the altitude of a leg's end, LINEAR in proportion to the distance flown.")
        AltitudeProfile altitudeProfile,
    @Variable(min = 1, max = 1000, ifAbsent = 3)
        @Description("Passes at a waypoint before giving up.")
        int attempts,
    @Variable(min = 0, max = 5, ifAbsent = 0)
        @Description(
            "Horizontal thresholds of waypoints are at least this many standard deviations of the state's position; 0: as given in the mission.")
        double thresholdSigmas,
    @Variable(ifAbsentText = "STOP")
        @Description(
            "After the last goal: HOLD stays at the last waypoint, STOP sends no navigation points.")
        AtEnd atEnd,
    @Variable(unit = "m", min = 0, ifAbsent = 0)
        @Description("Holding-circle radius; 0: hold in place.")
        double loiterRadius,
    @Variable(ifAbsentText = "false")
        @Description(
            "Whether a vehicle that pauses holds where it has come to rest instead of where it was when it was told: true for vehicles that stand without drifting, such as ground vehicles; of no effect if the vehicle DRIFTS.")
        boolean holdAtRest,
    @Variable(unit = "s", min = 0, minExcluded = true, ifAbsent = 1)
        @Description("Maximum age of a state used for planning.")
        double staleAfter,
    @Variable(unit = "s", min = 0, minExcluded = true, ifAbsent = 1)
        @Description(
            "Time after which the report of a finished goal is repeated unless the Mission Manager reacts.")
        double reportInterval) {
  /** Behaviour after the last goal. */
  enum AtEnd {
    /** Stays at the last waypoint. */
    HOLD,
    /** Publishes no navigation points. */
    STOP
  }

  LineSettings lines() {
    return lines(altitudeProfile);
  }

  LineSettings lines(AltitudeProfile altitudes) {
    return new LineSettings(
        lookAhead,
        lookAheadTime,
        new TurnAnticipation(turnAcceleration, turnLag, cornerLimit),
        altitudes);
  }

  boolean holdsAtEnd() {
    return atEnd == AtEnd.HOLD;
  }

  /** {@link #reportInterval} [µs]. */
  long reportIntervalMicros() {
    return Clock.micros(reportInterval);
  }
}
