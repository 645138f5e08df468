package org.u2sa.drivers.motor;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** The configuration variables of {@link WheelMotors}. */
final class WheelVariables {
  static final VariableDeclaration<String> CONNECTION =
      VariableDeclaration.text("CONNECTION")
          .ifAbsent("serial:/dev/ttyACM0?baud=115200")
          .describedAs("Where the motor controller is: serial:DEVICE?baud=N or tcp:HOST:PORT.");

  static final VariableDeclaration<Integer> ADDRESS =
      VariableDeclaration.integer("ADDRESS")
          .range(Range.of(128, 135))
          .ifAbsent(128)
          .describedAs("Address set at the RoboClaw; 128 is 0x80.");

  static final VariableDeclaration<Double> SERIAL_TIMEOUT =
      VariableDeclaration.number("SERIAL TIMEOUT", "s")
          .range(Range.of(0.1, 25.5))
          .ifAbsent(0.3)
          .describedAs("Without a word for longer the controller stops the motors by itself.");

  static final VariableDeclaration<String> LEFT_NAME =
      VariableDeclaration.text("LEFT ACTUATOR")
          .ifAbsent("LEFT MOTOR")
          .describedAs("Name to which commands for the left wheel are addressed.");

  static final VariableDeclaration<String> RIGHT_NAME =
      VariableDeclaration.text("RIGHT ACTUATOR")
          .ifAbsent("RIGHT MOTOR")
          .describedAs("Name to which commands for the right wheel are addressed.");

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
          .describedAs("Fastest change of a command; a stop is not limited.");

  static final VariableDeclaration<Double> COUNTS_PER_TURN =
      VariableDeclaration.number("COUNTS PER TURN", "")
          .range(Range.of(1.0, 1.0e7))
          .ifAbsent(1024.0)
          .describedAs("Counts of the encoder at one turn of the wheel: four a line, times gears.");

  static final VariableDeclaration<Double> WHEEL_DIAMETER =
      VariableDeclaration.number("WHEEL DIAMETER", "m")
          .range(Range.of(0.01, 10.0))
          .ifAbsent(0.25)
          .describedAs("Of the wheels, under load.");

  static final VariableDeclaration<Double> TRACK =
      VariableDeclaration.number("TRACK", "m")
          .range(Range.of(0.01, 10.0))
          .ifAbsent(0.5)
          .describedAs("Distance of the left and the right wheel.");

  static final VariableDeclaration<Double> SLIP =
      VariableDeclaration.number("SLIP", "")
          .range(Range.of(0.0, 1.0))
          .ifAbsent(0.03)
          .describedAs("Standard deviation of a wheel's speed, as a share of it.");

  static final VariableDeclaration<Double> FASTEST =
      VariableDeclaration.number("FASTEST", "m/s")
          .range(Range.of(0.1, 1000.0))
          .ifAbsent(15.0)
          .describedAs("Faster counts are not believed.");

  static final VariableDeclaration<Double> STATE_RATE =
      VariableDeclaration.number("STATE RATE", "Hz")
          .range(Range.of(0.1, 50.0))
          .ifAbsent(10.0)
          .describedAs("How often speeds are published.");

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
