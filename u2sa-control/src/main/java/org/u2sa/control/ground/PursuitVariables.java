package org.u2sa.control.ground;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** The variables of regulated pure pursuit, for every kind of ground vehicle. */
record PursuitVariables(
    @Variable(unit = "m/s", min = 0.05, max = 50, ifAbsent = 2)
        @Description("Measured ground speed at 100 %, straight ahead on typical ground.")
        double maxSpeed,
    @Variable(unit = "%", min = 0, max = 50, ifAbsent = 8)
        @Description(
            "Measured percentage at which the vehicle starts to move: friction and the motor controller's dead band.")
        double startPercentage,
    @Variable(unit = "m/s", min = 0.05, max = 20, ifAbsent = 1)
        @Description("Speed on a straight, unless the goal sets one.")
        double cruiseSpeed,
    @Variable(unit = "m/s^2", min = 0.05, max = 10, ifAbsent = 0.8)
        @Description("Maximum acceleration.")
        double acceleration,
    @Variable(unit = "m/s^2", min = 0.05, max = 10, ifAbsent = 1.2)
        @Description("Maximum deceleration.")
        double braking,
    @Variable(unit = "m", min = 0.05, max = 100, ifAbsent = 1)
        @Description(
            "Distance from the navigation point at which the vehicle starts to slow down; less than the planner's LOOK AHEAD.")
        double approachDistance,
    @Variable(unit = "m/s", min = 0.01, max = 5, ifAbsent = 0.15)
        @Description("Minimum speed on the way to a point.")
        double approachSpeed,
    @Variable(unit = "m", min = 0.01, max = 10, ifAbsent = 0.15)
        @Description(
            "Distance from the point at which the vehicle stops; less than the waypoint thresholds.")
        double tolerance,
    @Variable(unit = "m", min = 0, max = 100, ifAbsent = 0.9)
        @Description("Curve radius below which speed falls in proportion.")
        double regulatedRadius,
    @Variable(unit = "deg/s", min = 1, max = 720, ifAbsent = 70) @Description("Maximum yaw rate.")
        double turnRate,
    @Variable(unit = "deg/s^2", min = 1, max = 7200, ifAbsent = 180)
        @Description("Yaw-rate slew limit.")
        double turnRateChange,
    @Variable(unit = "1/s", min = 0, max = 10, ifAbsent = 0.5)
        @Description("Fraction of a speed error that feedback corrects per second; 0: no feedback.")
        double speedGain,
    @Variable(unit = "1/s", min = 0, max = 10, ifAbsent = 1)
        @Description(
            "Share of a yaw-rate error that feedback corrects per second while driving; 0: no feedback.")
        double turnGain,
    @Variable(unit = "s", min = 0, max = 5, ifAbsent = 0.3)
        @Description("Lag of the measured motion behind the commanded one, including sensors.")
        double responseTime,
    @Variable(unit = "s", min = 0, max = 10, ifAbsent = 0)
        @Description(
            "Time constant of the speed response (63 % from rest), for lead compensation; 0: no lead.")
        double pickUpTime,
    @Variable(unit = "s", min = 0.2, max = 60, ifAbsent = 3)
        @Description(
            "Stall detection: time at full power with hardly any motion before the motors are rested, with a warning.")
        double stallTime,
    @Variable(unit = "s", min = 0, max = 600, ifAbsent = 10)
        @Description("Time for which stalled motors rest before the vehicle tries again.")
        double stallPause) {
  private static final double FULL_PERCENT = 100.0;

  /** Calibration of the motors. */
  DriveCalibration calibration() {
    return new DriveCalibration(maxSpeed, startPercentage / FULL_PERCENT);
  }

  /** Maximum yaw rate [rad/s]. */
  double turnRateRadPerS() {
    return Math.toRadians(turnRate);
  }

  /** Maximum rate of change of the yaw rate [rad/s²]. */
  double turnAccelerationRadPerS2() {
    return Math.toRadians(turnRateChange);
  }
}
