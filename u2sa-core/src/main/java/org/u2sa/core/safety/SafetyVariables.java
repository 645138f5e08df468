package org.u2sa.core.safety;

import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** The configuration variables of the {@link SafetyManager}, those of the matrix aside. */
final class SafetyVariables {
  static final String TURN = "TURN";
  private static final String BRAKE = "BRAKE";
  private static final Range DEADLINE = Range.of(0.05, 3600.0);

  static final VariableDeclaration<Double> OPERATOR_DEADLINE =
      VariableDeclaration.number("OPERATOR DEADLINE", "s")
          .range(DEADLINE)
          .ifAbsent(5.0)
          .describedAs("Time without an operator's heartbeat after which the link counts as lost.");

  static final VariableDeclaration<Boolean> OPERATOR_REQUIRED =
      VariableDeclaration.flag("OPERATOR REQUIRED")
          .ifAbsent(false)
          .describedAs(
              "Whether an operator must be there to arm; otherwise one counts from its first heartbeat on.");

  static final VariableDeclaration<Double> STATE_DEADLINE =
      VariableDeclaration.number("STATE DEADLINE", "s")
          .range(DEADLINE)
          .ifAbsent(1.0)
          .describedAs("Age at which the state estimate counts as absent.");

  static final VariableDeclaration<Double> POSITION_SIGMA_LIMIT =
      VariableDeclaration.number("POSITION SIGMA LIMIT", "m")
          .range(Range.positive())
          .ifAbsent(50.0)
          .describedAs(
              "Standard deviation of x or y above which the position counts as lost; a state that says none is trusted.");

  static final VariableDeclaration<String> ESTIMATOR_SERVICE =
      VariableDeclaration.text("ESTIMATOR SERVICE")
          .ifAbsent("StateEstimator")
          .describedAs("Name of the service whose failure is the loss of the estimator.");

  static final VariableDeclaration<String> ACTUATOR_SERVICES =
      VariableDeclaration.text("ACTUATOR SERVICES")
          .ifAbsent("")
          .describedAs(
              "Names of the services whose failure is the loss of the actuator link, with commas between.");

  static final VariableDeclaration<String> MONITOR_SERVICE =
      VariableDeclaration.text("HEALTH MONITOR SERVICE")
          .ifAbsent("HealthMonitor")
          .describedAs("Name of the health monitor.");

  static final VariableDeclaration<Double> MONITOR_DEADLINE =
      VariableDeclaration.number("HEALTH MONITOR DEADLINE", "s")
          .range(DEADLINE)
          .ifAbsent(4.0)
          .describedAs("Time without a report of the health monitor after which it is lost.");

  static final VariableDeclaration<Boolean> MONITOR_REQUIRED =
      VariableDeclaration.flag("HEALTH MONITOR REQUIRED")
          .ifAbsent(false)
          .describedAs(
              "Whether a health monitor must be there to arm; otherwise one counts from its first report on.");

  static final VariableDeclaration<Double> LOW_VOLTAGE = voltage("LOW BATTERY VOLTAGE");
  static final VariableDeclaration<Double> LOW_REMAINING = remaining("LOW BATTERY REMAINING");
  static final VariableDeclaration<Double> CRITICAL_VOLTAGE = voltage("CRITICAL BATTERY VOLTAGE");
  static final VariableDeclaration<Double> CRITICAL_REMAINING =
      remaining("CRITICAL BATTERY REMAINING");

  static final VariableDeclaration<Double> BATTERY_TIME =
      VariableDeclaration.number("BATTERY TIME", "s")
          .range(Range.of(0.0, 3600.0))
          .ifAbsent(10.0)
          .describedAs("Time for which a battery must be below a level; a load makes it sag.");

  static final VariableDeclaration<Double> CLEAR_AFTER =
      VariableDeclaration.number("CLEAR AFTER", "s")
          .range(Range.of(0.0, 3600.0))
          .ifAbsent(3.0)
          .describedAs("Time for which a cause must be gone before it no longer counts.");

  static final VariableDeclaration<Boolean> RESUME =
      VariableDeclaration.flag("RESUME")
          .ifAbsent(false)
          .describedAs(
              "Whether RETURN and LAND end with their causes, the fence aside; otherwise they go on until an operator arms anew.");

  static final VariableDeclaration<Double> REPEAT_INTERVAL =
      VariableDeclaration.number("REPEAT INTERVAL", "s")
          .range(Range.of(0.1, 3600.0))
          .ifAbsent(1.0)
          .describedAs("Time between two publications of what has not changed.");

  static final VariableDeclaration<Boolean> ARM_AT_START =
      VariableDeclaration.flag("ARM AT START")
          .ifAbsent(false)
          .describedAs("Whether the vehicle is armed once, by itself, as soon as all checks pass.");

  static final VariableDeclaration<Boolean> MISSION_REQUIRED =
      VariableDeclaration.flag("MISSION REQUIRED")
          .ifAbsent(true)
          .describedAs("Whether there must be a goal to arm.");

  static final VariableDeclaration<String> REQUIRED_ACTUATORS =
      VariableDeclaration.text("REQUIRED ACTUATORS")
          .ifAbsent("")
          .describedAs(
              "Names of the actuators that must have announced themselves to arm, with commas between; empty: any one.");

  static final VariableDeclaration<String> FENCE =
      VariableDeclaration.text("FENCE")
          .ifAbsent("")
          .describedAs("The geofence's XML file, relative to this file; empty: no fence.");

  static final VariableDeclaration<String> FENCE_MANOEUVRE =
      VariableDeclaration.text("FENCE MANOEUVRE")
          .oneOf(BRAKE, TURN)
          .ifAbsent(BRAKE)
          .describedAs(
              "How the vehicle stays inside: it BRAKEs, or, as an aircraft, makes a TURN to either side.");

  static final VariableDeclaration<Double> REACTION_TIME =
      VariableDeclaration.number("REACTION TIME", "s")
          .range(Range.of(0.0, 60.0))
          .ifAbsent(1.0)
          .describedAs("Time from the failsafe until the vehicle brakes or turns.");

  static final VariableDeclaration<Double> BRAKING =
      VariableDeclaration.number("BRAKING", "m/s^2")
          .range(Range.positive())
          .ifAbsent(1.0)
          .describedAs("Deceleration with which the vehicle stops before the fence.");

  static final VariableDeclaration<Double> TURN_BANK =
      VariableDeclaration.number("TURN BANK", "rad")
          .range(Range.of(0.01, 1.4))
          .ifAbsent(0.4)
          .describedAs("Bank with which the aircraft turns away from the fence.");

  static final VariableDeclaration<Double> HOLD_RADIUS =
      VariableDeclaration.number("HOLD RADIUS", "m")
          .range(Range.nonNegative())
          .ifAbsent(0.0)
          .describedAs(
              "The planner's LOITER RADIUS: the circle for which there must be room before the fence if ON FENCE is HOLD.");

  static final VariableDeclaration<Double> WIND_ALLOWANCE =
      VariableDeclaration.number("WIND ALLOWANCE", "m/s")
          .range(Range.nonNegative())
          .ifAbsent(0.0)
          .describedAs("Wind that may blow a turning aircraft towards the fence.");

  static final VariableDeclaration<Double> VERTICAL_ACCELERATION =
      VariableDeclaration.number("VERTICAL ACCELERATION", "m/s^2")
          .range(Range.positive())
          .ifAbsent(0.8)
          .describedAs("Acceleration with which a climb ends before the ceiling, or a descent.");

  static final VariableDeclaration<Double> FENCE_MARGIN =
      VariableDeclaration.number("FENCE MARGIN", "m")
          .range(Range.nonNegative())
          .ifAbsent(0.0)
          .describedAs("By how much the fence is drawn in on all sides: errors of position.");

  private SafetyVariables() {}

  private static VariableDeclaration<Double> voltage(String name) {
    return VariableDeclaration.number(name, "V")
        .range(Range.nonNegative())
        .ifAbsent(0.0)
        .describedAs("Voltage below which a battery is so; 0: not looked at.");
  }

  private static VariableDeclaration<Double> remaining(String name) {
    return VariableDeclaration.number(name, "%")
        .range(Range.of(0.0, 100.0))
        .ifAbsent(0.0)
        .describedAs("Charge left below which a battery is so; 0: not looked at.");
  }
}
