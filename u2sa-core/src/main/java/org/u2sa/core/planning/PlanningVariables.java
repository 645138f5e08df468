package org.u2sa.core.planning;

import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/**
 * The configuration variables of the {@link PathPlanner}. Only these tell an aircraft from a ground
 * vehicle.
 */
final class PlanningVariables {
  static final String LINE = "LINE";
  private static final String DIRECT = "DIRECT";
  static final String HOLD = "HOLD";
  private static final String STOP = "STOP";

  static final VariableDeclaration<String> GUIDANCE =
      VariableDeclaration.text("GUIDANCE")
          .oneOf(LINE, DIRECT)
          .ifAbsent(LINE)
          .describedAs(
              "LINE follows the lines between waypoints; DIRECT heads straight for the waypoint and hands control unit vectors"
                  + " (thesis 4.5.2.4).");

  static final VariableDeclaration<Double> LOOK_AHEAD =
      VariableDeclaration.number("LOOK AHEAD", "m")
          .range(Range.positive())
          .ifAbsent(1.0)
          .describedAs(
              "Least distance ahead, on the line, of the point to go to. Shorter holds the line tighter.");

  static final VariableDeclaration<Double> LOOK_AHEAD_TIME =
      VariableDeclaration.number("LOOK AHEAD TIME", "s")
          .range(Range.nonNegative())
          .ifAbsent(1.0)
          .describedAs(
              "The same as a time: the point is at least as far ahead as the vehicle gets in it.");

  static final VariableDeclaration<Double> TURN_ACCELERATION =
      VariableDeclaration.number("TURN ACCELERATION", "m/s^2")
          .range(Range.nonNegative())
          .ifAbsent(0.0)
          .describedAs(
              "Lateral acceleration of turns: g tan(bank) for aircraft; 0 for a vehicle that turns on the spot.");

  static final VariableDeclaration<Double> TURN_LAG =
      VariableDeclaration.number("TURN LAG", "s")
          .range(Range.nonNegative())
          .ifAbsent(0.0)
          .describedAs(
              "Time from the order to turn until the turn is under way: the roll-in of an aircraft.");

  static final VariableDeclaration<Double> CORNER_LIMIT =
      VariableDeclaration.number("CORNER LIMIT", "m")
          .range(Range.nonNegative())
          .ifAbsent(60.0)
          .describedAs(
              "Most by which a turn may cut the corner at a waypoint, however large its threshold.");

  static final VariableDeclaration<String> ALTITUDE_PROFILE =
      VariableDeclaration.text("ALTITUDE PROFILE")
          .oneOf(AltitudeProfile.IMMEDIATE.name(), AltitudeProfile.LINEAR.name())
          .ifAbsent(AltitudeProfile.IMMEDIATE.name())
          .describedAs(
              "Whether a leg's altitude is that of its end at once, or changes in proportion to the way.");

  static final VariableDeclaration<Integer> ATTEMPTS =
      VariableDeclaration.integer("ATTEMPTS")
          .range(Range.of(1, 1000))
          .ifAbsent(3)
          .describedAs("Passes at a waypoint before it is given up.");

  static final VariableDeclaration<String> AT_END =
      VariableDeclaration.text("AT END")
          .oneOf(HOLD, STOP)
          .ifAbsent(STOP)
          .describedAs(
              "What follows the last goal: HOLD stays at the last waypoint, STOP gives no navigation points.");

  static final VariableDeclaration<Double> LOITER_RADIUS =
      VariableDeclaration.number("LOITER RADIUS", "m")
          .range(Range.nonNegative())
          .ifAbsent(0.0)
          .describedAs("Radius of the circle on which to hold; 0 holds the place itself.");

  static final VariableDeclaration<Double> STALE_AFTER =
      VariableDeclaration.number("STALE AFTER", "s")
          .range(Range.positive())
          .ifAbsent(1.0)
          .describedAs("Age at which a state is too old to plan from.");

  static final VariableDeclaration<Double> REPORT_INTERVAL =
      VariableDeclaration.number("REPORT INTERVAL", "s")
          .range(Range.positive())
          .ifAbsent(1.0)
          .describedAs(
              "Time after which a report of a finished goal is repeated if the Mission Manager did not react.");

  private PlanningVariables() {}
}
