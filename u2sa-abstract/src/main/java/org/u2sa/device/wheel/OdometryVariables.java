package org.u2sa.device.wheel;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Configuration variables of wheel odometry. */
public record OdometryVariables(
    @Variable(min = 1, max = 1.0e7, ifAbsent = 1024)
        @Description("Encoder counts per wheel revolution: four per line, times the gear ratio.")
        double countsPerTurn,
    @Variable(unit = "m", min = 0.01, max = 10, ifAbsent = 0.25)
        @Description("Diameter of the wheels under load.")
        double wheelDiameter,
    @Variable(unit = "m", min = 0.01, max = 10, ifAbsent = 0.5)
        @Description("Distance between the left and the right wheel.")
        double track,
    @Variable(min = 0, max = 1, ifAbsent = 0.03)
        @Description("Standard deviation of a wheel's speed, as a fraction of the speed.")
        double slip,
    @Variable(unit = "m/s", min = 0.1, max = 1000, ifAbsent = 15)
        @Description("Maximum plausible speed: counts that imply more are dropped.")
        double fastest) {
  /** The odometry that the variables describe. */
  public WheelOdometry odometry() {
    return new WheelOdometry(Math.PI * wheelDiameter / countsPerTurn, track, slip, fastest);
  }
}
