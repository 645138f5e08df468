package org.u2sa.core.control.ground;

import org.u2sa.interfaces.configuration.Variable;

/** The variables of regulated pure pursuit, for every kind of ground vehicle. */
record PursuitTuning(
    @Variable(
            unit = "m/s",
            min = 0.05,
            max = 50,
            ifAbsent = 2,
            text =
                "Speed over ground at 100 %, straight ahead on the ground that is driven on; measured.")
        double maxSpeed,
    @Variable(
            unit = "%",
            min = 0,
            max = 50,
            ifAbsent = 8,
            text =
                "At which the vehicle begins to move: friction and the motor controller's dead band; measured.")
        double startPercentage,
    @Variable(
            unit = "m/s",
            min = 0.05,
            max = 20,
            ifAbsent = 1,
            text = "Speed on a straight, unless the goal says one.")
        double cruiseSpeed,
    @Variable(
            unit = "m/s^2",
            min = 0.05,
            max = 10,
            ifAbsent = 0.8,
            text = "With which the vehicle gets faster.")
        double acceleration,
    @Variable(
            unit = "m/s^2",
            min = 0.05,
            max = 10,
            ifAbsent = 1.2,
            text = "With which the vehicle gets slower.")
        double braking,
    @Variable(
            unit = "m",
            min = 0.05,
            max = 100,
            ifAbsent = 1,
            text =
                "Distance to the point to go to from which on the vehicle slows down; less than the planner's LOOK AHEAD.")
        double approachDistance,
    @Variable(
            unit = "m/s",
            min = 0.01,
            max = 5,
            ifAbsent = 0.15,
            text = "Least speed on the way to a point.")
        double approachSpeed,
    @Variable(
            unit = "m",
            min = 0.01,
            max = 10,
            ifAbsent = 0.15,
            text =
                "Distance at which the vehicle has arrived and stands; less than the thresholds of waypoints.")
        double tolerance,
    @Variable(
            unit = "m",
            min = 0,
            max = 100,
            ifAbsent = 0.9,
            text = "Curves of a smaller radius are driven slower, in proportion.")
        double regulatedRadius,
    @Variable(unit = "deg/s", min = 1, max = 720, ifAbsent = 70, text = "Most yaw rate.")
        double turnRate,
    @Variable(
            unit = "deg/s^2",
            min = 1,
            max = 7200,
            ifAbsent = 180,
            text = "How fast the yaw rate may change.")
        double turnRateChange,
    @Variable(
            unit = "1/s",
            min = 0,
            max = 10,
            ifAbsent = 0.5,
            text =
                "Share of an error of the speed that feedback takes out in a second; 0: no feedback.")
        double speedGain,
    @Variable(
            unit = "1/s",
            min = 0,
            max = 10,
            ifAbsent = 1,
            text =
                "Share of an error of the yaw rate that feedback takes out in a second while driving; 0: no feedback.")
        double turnGain,
    @Variable(
            unit = "s",
            min = 0,
            max = 5,
            ifAbsent = 0.3,
            text = "How late the measured motion follows the commanded one, sensors included.")
        double responseTime,
    @Variable(
            unit = "s",
            min = 0.2,
            max = 60,
            ifAbsent = 3,
            text =
                "How long motors at full power may hardly move the vehicle, before it is said and they rest.")
        double stallTime,
    @Variable(
            unit = "s",
            min = 0,
            max = 600,
            ifAbsent = 10,
            text = "How long the motors rest then, before the vehicle tries again.")
        double stallPause) {
  private static final double FULL_PERCENT = 100.0;

  /** What the motors make of commands. */
  DriveCalibration calibration() {
    return new DriveCalibration(maxSpeed, startPercentage / FULL_PERCENT);
  }

  /**
   * The law's gains and limits.
   *
   * @param largestCurvature that the vehicle can drive [1/m]
   */
  PursuitSettings settings(double largestCurvature, PursuitSettings.SpotTurn spotTurn) {
    return new PursuitSettings(
        cruiseSpeed,
        acceleration,
        braking,
        approachDistance,
        approachSpeed,
        tolerance,
        regulatedRadius,
        largestCurvature,
        Math.toRadians(turnRate),
        Math.toRadians(turnRateChange),
        spotTurn);
  }
}
