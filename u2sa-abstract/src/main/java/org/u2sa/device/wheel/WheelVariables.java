package org.u2sa.device.wheel;

import org.u2sa.device.WheelMotors;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Configuration variables of {@link WheelMotors}, except its {@link OdometryVariables}. */
public record WheelVariables(
    @Variable(unit = "s", min = 0.1, max = 25.5, ifAbsent = 0.3)
        @Description(
            "Time without a message after which the controller stops the motors by itself.")
        double serialTimeout,
    @Variable(ifAbsentText = "LEFT MOTOR") @Description("Actuator name of the left wheel.")
        String leftActuator,
    @Variable(ifAbsentText = "RIGHT MOTOR") @Description("Actuator name of the right wheel.")
        String rightActuator,
    @Variable(ifAbsentText = "false")
        @Description("Whether the left wheel is on the controller's second channel.")
        boolean leftIsSecond,
    @Variable(ifAbsentText = "false")
        @Description("Whether positive duty turns the left wheel backwards.")
        boolean leftReversed,
    @Variable(ifAbsentText = "false")
        @Description("Whether positive duty turns the right wheel backwards.")
        boolean rightReversed,
    @Variable(unit = "%", min = 1, max = 100, ifAbsent = 100)
        @Description("Duty cycle at a command of 100 %.")
        double fullDuty,
    @Variable(unit = "%/s", min = 1, max = 100_000, ifAbsent = 400)
        @Description("Maximum rate of change of a command; stops are not limited.")
        double slewLimit,
    @Variable(unit = "Hz", min = 0.1, max = 50, ifAbsent = 10)
        @Description("Rate of published speeds.")
        double stateRate) {
  /** Rejects one actuator for both sides. */
  public WheelVariables {
    if (leftActuator.equals(rightActuator)) {
      throw new IllegalArgumentException(
          "LEFT ACTUATOR and RIGHT ACTUATOR are both \"" + leftActuator + "\"");
    }
  }
}
