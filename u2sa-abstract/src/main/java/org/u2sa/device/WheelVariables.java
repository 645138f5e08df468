package org.u2sa.device;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** The configuration variables of {@link WheelMotors}. */
final class WheelVariables {
  static final VariableDeclaration<String> CONNECTION =
      VariableDeclaration.text("CONNECTION")
          .ifAbsent("serial:/dev/ttyACM0?baud=115200")
          .describedAs(
              "Address of the motor controller, as its driver takes it (docs/drivers/links.md).");

  static final VariableDeclaration<String> CONTROLLER =
      VariableDeclaration.text("CONTROLLER")
          .ifAbsent("ROBOCLAW")
          .describedAs("Kind of motor controller: the name of a driver.");

  static final VariableDeclaration<Double> SERIAL_TIMEOUT =
      VariableDeclaration.number("SERIAL TIMEOUT", "s")
          .range(Range.of(0.1, 25.5))
          .ifAbsent(0.3)
          .describedAs(
              "Time without a message after which the controller stops the motors by itself.");

  static final VariableDeclaration<String> LEFT_NAME =
      VariableDeclaration.text("LEFT ACTUATOR")
          .ifAbsent("LEFT MOTOR")
          .describedAs("Actuator name of the left wheel.");

  static final VariableDeclaration<String> RIGHT_NAME =
      VariableDeclaration.text("RIGHT ACTUATOR")
          .ifAbsent("RIGHT MOTOR")
          .describedAs("Actuator name of the right wheel.");

  static final VariableDeclaration<Boolean> LEFT_IS_SECOND =
      VariableDeclaration.flag("LEFT IS SECOND")
          .ifAbsent(false)
          .describedAs("Whether the left wheel is at the controller's second channel.");

  static final VariableDeclaration<Boolean> LEFT_REVERSED =
      VariableDeclaration.flag("LEFT REVERSED")
          .ifAbsent(false)
          .describedAs("Whether positive duty turns the left wheel backwards.");

  static final VariableDeclaration<Boolean> RIGHT_REVERSED =
      VariableDeclaration.flag("RIGHT REVERSED")
          .ifAbsent(false)
          .describedAs("Whether positive duty turns the right wheel backwards.");

  static final VariableDeclaration<Double> FULL_DUTY =
      VariableDeclaration.number("FULL DUTY", "%")
          .range(Range.of(1.0, 100.0))
          .ifAbsent(100.0)
          .describedAs("Duty cycle at a command of 100 %.");

  static final VariableDeclaration<Double> SLEW_LIMIT =
      VariableDeclaration.number("SLEW LIMIT", "%/s")
          .range(Range.of(1.0, 100_000.0))
          .ifAbsent(400.0)
          .describedAs("Fastest change of a command; stops are not limited.");

  static final VariableDeclaration<Double> COUNTS_PER_TURN =
      VariableDeclaration.number("COUNTS PER TURN", "")
          .range(Range.of(1.0, 1.0e7))
          .ifAbsent(1024.0)
          .describedAs(
              "Encoder counts per turn of the wheel: four per line, times the gear ratio.");

  static final VariableDeclaration<Double> WHEEL_DIAMETER =
      VariableDeclaration.number("WHEEL DIAMETER", "m")
          .range(Range.of(0.01, 10.0))
          .ifAbsent(0.25)
          .describedAs("Diameter of the wheels under load.");

  static final VariableDeclaration<Double> TRACK =
      VariableDeclaration.number("TRACK", "m")
          .range(Range.of(0.01, 10.0))
          .ifAbsent(0.5)
          .describedAs("Distance between the left and the right wheel.");

  static final VariableDeclaration<Double> SLIP =
      VariableDeclaration.number("SLIP", "")
          .range(Range.of(0.0, 1.0))
          .ifAbsent(0.03)
          .describedAs("Standard deviation of a wheel's speed, as a share of it.");

  static final VariableDeclaration<Double> FASTEST =
      VariableDeclaration.number("FASTEST", "m/s")
          .range(Range.of(0.1, 1000.0))
          .ifAbsent(15.0)
          .describedAs("Fastest plausible speed: counts that tell of a higher one are dropped.");

  static final VariableDeclaration<Double> STATE_RATE =
      VariableDeclaration.number("STATE RATE", "Hz")
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
