package org.u2sa.drivers.motor;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.Variable;

/** The configuration variables of {@link WheelMotors}. */
final class WheelVariables {
  static final Variable<String> CONNECTION =
      Variable.text("CONNECTION")
          .ifAbsent("serial:/dev/ttyACM0?baud=115200")
          .describedAs("Where the motor controller is: serial:DEVICE?baud=N or tcp:HOST:PORT.");

  static final Variable<Integer> ADDRESS =
      Variable.integer("ADDRESS")
          .range(Range.of(128, 135))
          .ifAbsent(128)
          .describedAs("Address set at the RoboClaw; 128 is 0x80.");

  static final Variable<Double> SERIAL_TIMEOUT =
      Variable.number("SERIAL TIMEOUT", "s")
          .range(Range.of(0.1, 25.5))
          .ifAbsent(0.3)
          .describedAs("Without a word for longer the controller stops the motors by itself.");

  static final Variable<String> LEFT_NAME =
      Variable.text("LEFT ACTUATOR")
          .ifAbsent("LEFT MOTOR")
          .describedAs("Name to which commands for the left wheel are addressed.");

  static final Variable<String> RIGHT_NAME =
      Variable.text("RIGHT ACTUATOR")
          .ifAbsent("RIGHT MOTOR")
          .describedAs("Name to which commands for the right wheel are addressed.");

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
          .describedAs("Fastest change of a command; a stop is not limited.");

  static final Variable<Double> COUNTS_PER_TURN =
      Variable.number("COUNTS PER TURN", "")
          .range(Range.of(1.0, 1.0e7))
          .ifAbsent(1024.0)
          .describedAs("Counts of the encoder at one turn of the wheel: four a line, times gears.");

  static final Variable<Double> WHEEL_DIAMETER =
      Variable.number("WHEEL DIAMETER", "m")
          .range(Range.of(0.01, 10.0))
          .ifAbsent(0.25)
          .describedAs("Of the wheels, under load.");

  static final Variable<Double> TRACK =
      Variable.number("TRACK", "m")
          .range(Range.of(0.01, 10.0))
          .ifAbsent(0.5)
          .describedAs("Distance of the left and the right wheel.");

  static final Variable<Double> SLIP =
      Variable.number("SLIP", "")
          .range(Range.of(0.0, 1.0))
          .ifAbsent(0.03)
          .describedAs("Standard deviation of a wheel's speed, as a share of it.");

  static final Variable<Double> FASTEST =
      Variable.number("FASTEST", "m/s")
          .range(Range.of(0.1, 1000.0))
          .ifAbsent(15.0)
          .describedAs("Faster counts are not believed.");

  static final Variable<Double> STATE_RATE =
      Variable.number("STATE RATE", "Hz")
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
