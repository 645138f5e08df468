package org.u2sa.device;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.Variable;

/** The configuration variables of {@link WheelMotors}. */
final class WheelVariables {
  static final Variable<String> CONNECTION =
      Variable.text("CONNECTION")
          .ifAbsent("serial:/dev/ttyACM0?baud=115200")
          .describedAs(
              "Address of the motor controller, as its driver takes it (docs/drivers/links.md).");

  static final Variable<String> CONTROLLER =
      Variable.text("CONTROLLER")
          .ifAbsent("ROBOCLAW")
          .describedAs("Kind of motor controller: the name of a driver.");

  static final Variable<Double> SERIAL_TIMEOUT =
      Variable.number("SERIAL TIMEOUT", "s")
          .range(Range.of(0.1, 25.5))
          .ifAbsent(0.3)
          .describedAs(
              "Time without a message after which the controller stops the motors by itself.");

  static final Variable<String> LEFT_NAME =
      Variable.text("LEFT ACTUATOR")
          .ifAbsent("LEFT MOTOR")
          .describedAs("Actuator name of the left wheel.");

  static final Variable<String> RIGHT_NAME =
      Variable.text("RIGHT ACTUATOR")
          .ifAbsent("RIGHT MOTOR")
          .describedAs("Actuator name of the right wheel.");

  static final Variable<Boolean> LEFT_IS_SECOND =
      Variable.flag("LEFT IS SECOND")
          .ifAbsent(false)
          .describedAs("Whether the left wheel is at the controller's second channel.");

  static final Variable<Boolean> LEFT_REVERSED =
      Variable.flag("LEFT REVERSED")
          .ifAbsent(false)
          .describedAs("Whether positive duty turns the left wheel backwards.");

  static final Variable<Boolean> RIGHT_REVERSED =
      Variable.flag("RIGHT REVERSED")
          .ifAbsent(false)
          .describedAs("Whether positive duty turns the right wheel backwards.");

  static final Variable<Double> FULL_DUTY =
      Variable.number("FULL DUTY", "%")
          .range(Range.of(1.0, 100.0))
          .ifAbsent(100.0)
          .describedAs("Duty cycle at a command of 100 %.");

  static final Variable<Double> SLEW_LIMIT =
      Variable.number("SLEW LIMIT", "%/s")
          .range(Range.of(1.0, 100_000.0))
          .ifAbsent(400.0)
          .describedAs("Fastest change of a command; stops are not limited.");

  static final Variable<Double> COUNTS_PER_TURN =
      Variable.number("COUNTS PER TURN", "")
          .range(Range.of(1.0, 1.0e7))
          .ifAbsent(1024.0)
          .describedAs(
              "Encoder counts per turn of the wheel: four per line, times the gear ratio.");

  static final Variable<Double> WHEEL_DIAMETER =
      Variable.number("WHEEL DIAMETER", "m")
          .range(Range.of(0.01, 10.0))
          .ifAbsent(0.25)
          .describedAs("Diameter of the wheels under load.");

  static final Variable<Double> TRACK =
      Variable.number("TRACK", "m")
          .range(Range.of(0.01, 10.0))
          .ifAbsent(0.5)
          .describedAs("Distance between the left and the right wheel.");

  static final Variable<Double> SLIP =
      Variable.number("SLIP", "")
          .range(Range.of(0.0, 1.0))
          .ifAbsent(0.03)
          .describedAs("Standard deviation of a wheel's speed, as a share of it.");

  static final Variable<Double> FASTEST =
      Variable.number("FASTEST", "m/s")
          .range(Range.of(0.1, 1000.0))
          .ifAbsent(15.0)
          .describedAs("Fastest plausible speed: counts that tell of a higher one are dropped.");

  static final Variable<Double> STATE_RATE =
      Variable.number("STATE RATE", "Hz")
          .range(Range.of(0.1, 50.0))
          .ifAbsent(10.0)
          .describedAs("Rate of published speeds.");

  private WheelVariables() {}

  /** The odometry that the variables describe. */
  static WheelOdometry odometry(Configurator variables) {
    double way = Math.PI * variables.getVariable(WHEEL_DIAMETER);
    return new WheelOdometry(
        way / variables.getVariable(COUNTS_PER_TURN),
        variables.getVariable(TRACK),
        variables.getVariable(SLIP),
        variables.getVariable(FASTEST));
  }
}
