package org.u2sa.core.planning;

import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;

/**
 * The configuration variables of every {@link PathPlanner}. Only these tell an aircraft from a
 * ground vehicle.
 */
record PlanningSettings(
    @Variable(
            unit = "m/s^2",
            min = 0,
            ifAbsent = 0,
            text =
                "Lateral acceleration of turns: g tan(bank) for aircraft; 0 for a vehicle that turns on the spot.")
        double turnAcceleration,
    @Variable(
            unit = "s",
            min = 0,
            ifAbsent = 0,
            text =
                "Time from the order to turn until the turn is under way: the roll-in of an aircraft.")
        double turnLag,
    @Variable(
            unit = "m",
            min = 0,
            ifAbsent = 60,
            text =
                "Most by which a turn may cut the corner at a waypoint, however large its threshold.")
        double cornerLimit,
    @Variable(
            unit = "m",
            min = 0,
            minExcluded = true,
            ifAbsent = 1,
            text =
                "Least distance ahead, on the line, of the point to go to. Shorter holds the line tighter.")
        double lookAhead,
    @Variable(
            unit = "s",
            min = 0,
            ifAbsent = 1,
            text =
                "The same as a time: the point is at least as far ahead as the vehicle gets in it.")
        double lookAheadTime,
    @Variable(
            ifAbsentText = "IMMEDIATE",
            text =
                "Whether a leg's altitude is that of its end at once, or changes in proportion to the way.")
        AltitudeProfile altitudeProfile,
    @Variable(
            min = 1,
            max = 1000,
            ifAbsent = 3,
            text = "Passes at a waypoint before it is given up.")
        int attempts,
    @Variable(
            ifAbsentText = "STOP",
            text =
                "What follows the last goal: HOLD stays at the last waypoint, STOP gives no navigation points.")
        AtEnd atEnd,
    @Variable(
            unit = "m",
            min = 0,
            ifAbsent = 0,
            text = "Radius of the circle on which to hold; 0 holds the place itself.")
        double loiterRadius,
    @Variable(
            unit = "s",
            min = 0,
            minExcluded = true,
            ifAbsent = 1,
            text = "Age at which a state is too old to plan from.")
        double staleAfter,
    @Variable(
            unit = "s",
            min = 0,
            minExcluded = true,
            ifAbsent = 1,
            text =
                "Time after which a report of a finished goal is repeated if the Mission Manager did not react.")
        double reportInterval) {
  /** What follows the last goal. */
  enum AtEnd {
    /** Stays at the last waypoint. */
    HOLD,
    /** Gives no navigation points. */
    STOP
  }

  /** How lines are followed. */
  LineSettings lines() {
    return lines(altitudeProfile);
  }

  /** The same, with altitudes as said. */
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
