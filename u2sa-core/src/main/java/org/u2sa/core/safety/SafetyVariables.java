package org.u2sa.core.safety;

import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.Variable;

/** The configuration variables of the {@link SafetyManager}, those of the matrix aside. */
final class SafetyVariables {
  static final String TURN = "TURN";
  private static final String BRAKE = "BRAKE";
  private static final Range DEADLINE = Range.of(0.05, 3600.0);

  static final Variable<Double> OPERATOR_DEADLINE =
      Variable.number("OPERATOR DEADLINE", "s")
          .range(DEADLINE)
          .ifAbsent(5.0)
          .describedAs("Time without an operator's heartbeat after which the link counts as lost.");

  static final Variable<Boolean> OPERATOR_REQUIRED =
      Variable.flag("OPERATOR REQUIRED")
          .ifAbsent(false)
          .describedAs(
              "Whether an operator must be there to arm; otherwise one counts from its first heartbeat on.");

  static final Variable<Double> STATE_DEADLINE =
      Variable.number("STATE DEADLINE", "s")
          .range(DEADLINE)
          .ifAbsent(1.0)
          .describedAs("Age at which the state estimate counts as absent.");

  static final Variable<Double> POSITION_SIGMA_LIMIT =
      Variable.number("POSITION SIGMA LIMIT", "m")
          .range(Range.positive())
          .ifAbsent(50.0)
          .describedAs(
              "Standard deviation of x or y above which the position counts as lost; a state that says none is trusted.");

  static final Variable<String> ESTIMATOR_SERVICE =
      Variable.text("ESTIMATOR SERVICE")
          .ifAbsent("StateEstimator")
          .describedAs("Name of the service whose failure is the loss of the estimator.");

  static final Variable<String> ACTUATOR_SERVICES =
      Variable.text("ACTUATOR SERVICES")
          .ifAbsent("")
          .describedAs(
              "Names of the services whose failure is the loss of the actuator link, with commas between.");

  static final Variable<String> MONITOR_SERVICE =
      Variable.text("HEALTH MONITOR SERVICE")
          .ifAbsent("HealthMonitor")
          .describedAs("Name of the health monitor.");

  static final Variable<Double> MONITOR_DEADLINE =
      Variable.number("HEALTH MONITOR DEADLINE", "s")
          .range(DEADLINE)
          .ifAbsent(4.0)
          .describedAs("Time without a report of the health monitor after which it is lost.");

  static final Variable<Boolean> MONITOR_REQUIRED =
      Variable.flag("HEALTH MONITOR REQUIRED")
          .ifAbsent(false)
          .describedAs(
              "Whether a health monitor must be there to arm; otherwise one counts from its first report on.");

  static final Variable<Double> LOW_VOLTAGE = voltage("LOW BATTERY VOLTAGE");
  static final Variable<Double> LOW_REMAINING = remaining("LOW BATTERY REMAINING");
  static final Variable<Double> CRITICAL_VOLTAGE = voltage("CRITICAL BATTERY VOLTAGE");
  static final Variable<Double> CRITICAL_REMAINING = remaining("CRITICAL BATTERY REMAINING");

  static final Variable<Double> BATTERY_TIME =
      Variable.number("BATTERY TIME", "s")
          .range(Range.of(0.0, 3600.0))
          .ifAbsent(10.0)
          .describedAs("Time for which a battery must be below a level; a load makes it sag.");

  static final Variable<Double> CLEAR_AFTER =
      Variable.number("CLEAR AFTER", "s")
          .range(Range.of(0.0, 3600.0))
          .ifAbsent(3.0)
          .describedAs("Time for which a cause must be gone before it no longer counts.");

  static final Variable<Boolean> RESUME =
      Variable.flag("RESUME")
          .ifAbsent(false)
          .describedAs(
              "Whether RETURN and LAND end with their causes, the fence aside; otherwise they go on until an operator arms anew.");

  static final Variable<Double> REPEAT_INTERVAL =
      Variable.number("REPEAT INTERVAL", "s")
          .range(Range.of(0.1, 3600.0))
          .ifAbsent(1.0)
          .describedAs("Time between two publications of what has not changed.");

  static final Variable<Boolean> ARM_AT_START =
      Variable.flag("ARM AT START")
          .ifAbsent(false)
          .describedAs("Whether the vehicle is armed once, by itself, as soon as all checks pass.");

  static final Variable<Boolean> MISSION_REQUIRED =
      Variable.flag("MISSION REQUIRED")
          .ifAbsent(true)
          .describedAs("Whether there must be a goal to arm.");

  static final Variable<String> REQUIRED_ACTUATORS =
      Variable.text("REQUIRED ACTUATORS")
          .ifAbsent("")
          .describedAs(
              "Names of the actuators that must have announced themselves to arm, with commas between; empty: any one.");

  static final Variable<String> FENCE =
      Variable.text("FENCE")
          .ifAbsent("")
          .describedAs("The geofence's XML file, relative to this file; empty: no fence.");

  static final Variable<String> FENCE_MANOEUVRE =
      Variable.text("FENCE MANOEUVRE")
          .oneOf(BRAKE, TURN)
          .ifAbsent(BRAKE)
          .describedAs(
              "How the vehicle stays inside: it BRAKEs, or, as an aircraft, makes a TURN to either side.");

  static final Variable<Double> REACTION_TIME =
      Variable.number("REACTION TIME", "s")
          .range(Range.of(0.0, 60.0))
          .ifAbsent(1.0)
          .describedAs("Time from the failsafe until the vehicle brakes or turns.");

  static final Variable<Double> BRAKING =
      Variable.number("BRAKING", "m/s^2")
          .range(Range.positive())
          .ifAbsent(1.0)
          .describedAs("Deceleration with which the vehicle stops before the fence.");

  static final Variable<Double> TURN_BANK =
      Variable.number("TURN BANK", "rad")
          .range(Range.of(0.01, 1.4))
          .ifAbsent(0.4)
          .describedAs("Bank with which the aircraft turns away from the fence.");

  static final Variable<Double> HOLD_RADIUS =
      Variable.number("HOLD RADIUS", "m")
          .range(Range.nonNegative())
          .ifAbsent(0.0)
          .describedAs(
              "The planner's LOITER RADIUS: the circle for which there must be room before the fence if ON FENCE is HOLD.");

  static final Variable<Double> WIND_ALLOWANCE =
      Variable.number("WIND ALLOWANCE", "m/s")
          .range(Range.nonNegative())
          .ifAbsent(0.0)
          .describedAs("Wind that may blow a turning aircraft towards the fence.");

  static final Variable<Double> VERTICAL_ACCELERATION =
      Variable.number("VERTICAL ACCELERATION", "m/s^2")
          .range(Range.positive())
          .ifAbsent(0.8)
          .describedAs("Acceleration with which a climb ends before the ceiling, or a descent.");

  static final Variable<Double> FENCE_MARGIN =
      Variable.number("FENCE MARGIN", "m")
          .range(Range.nonNegative())
          .ifAbsent(0.0)
          .describedAs("By how much the fence is drawn in on all sides: errors of position.");

  private SafetyVariables() {}

  private static Variable<Double> voltage(String name) {
    return Variable.number(name, "V")
        .range(Range.nonNegative())
        .ifAbsent(0.0)
        .describedAs("Voltage below which a battery is so; 0: not looked at.");
  }

  private static Variable<Double> remaining(String name) {
    return Variable.number(name, "%")
        .range(Range.of(0.0, 100.0))
        .ifAbsent(0.0)
        .describedAs("Charge left below which a battery is so; 0: not looked at.");
  }
}
