package org.u2sa.sim.sensor;

import org.u2sa.sim.motion.Arguments;

/**
 * A two-axis magnetometer on a level vehicle, with residual errors after calibration.
 *
 * @param rateHz headings per second
 * @param declinationRad magnetic declination, east positive [rad]
 * @param horizontalUt the earth's horizontal field [µT]
 * @param hardForwardUt hard-iron field, forward [µT]
 * @param hardRightUt hard-iron field, right [µT]
 * @param softForward soft-iron gain along the vehicle
 * @param softRight soft-iron gain across the vehicle
 * @param softCross soft-iron cross-coupling between both axes
 * @param forwardUtPerA field per motor current, forward [µT/A]
 * @param rightUtPerA field per left-motor current, right; opposite for the right motor [µT/A]
 * @param noiseUt noise per axis and reading [µT]
 */
public record CompassParameters(
    double rateHz,
    double declinationRad,
    double horizontalUt,
    double hardForwardUt,
    double hardRightUt,
    double softForward,
    double softRight,
    double softCross,
    double forwardUtPerA,
    double rightUtPerA,
    double noiseUt) {
  /**
   * @throws IllegalArgumentException if a value is outside its range
   */
  public CompassParameters {
    Arguments.requireInside("compass rate", rateHz, 0.1, 200.0);
    Arguments.requireInside("declination", declinationRad, -Math.PI, Math.PI);
    Arguments.requireInside("horizontal field", horizontalUt, 1.0, 60.0);
    Arguments.requireInside("hard iron", hardForwardUt, -200.0, 200.0);
    Arguments.requireInside("hard iron", hardRightUt, -200.0, 200.0);
    Arguments.requireInside("soft iron", softForward, -0.9, 2.0);
    Arguments.requireInside("soft iron", softRight, -0.9, 2.0);
    Arguments.requireInside("soft iron", softCross, -0.9, 0.9);
    Arguments.requireInside("field by current", forwardUtPerA, -10.0, 10.0);
    Arguments.requireInside("field by current", rightUtPerA, -10.0, 10.0);
    Arguments.requireInside("compass noise", noiseUt, 0.0, 50.0);
  }

  /**
   * A calibrated smart compass such as the Sparton SP3004D: 0.3° noise, 0.5° residual calibration
   * error, another 0.5° at 10 A of motor current. Field of the eastern United States.
   */
  public static CompassParameters calibrated(double declinationRad) {
    return new CompassParameters(
        20.0, declinationRad, 21.0, 0.12, -0.15, 0.004, -0.003, 0.003, 0.004, 0.01, 0.1);
  }

  /** A phone's magnetometer next to the motors: several degrees of each error. */
  public static CompassParameters phone(double declinationRad) {
    return new CompassParameters(
        20.0, declinationRad, 21.0, 1.2, -1.5, 0.03, -0.04, 0.02, 0.03, 0.05, 0.5);
  }

  /** An ideal compass. */
  public static CompassParameters perfect(double declinationRad) {
    return new CompassParameters(20.0, declinationRad, 21.0, 0, 0, 0, 0, 0, 0, 0, 0);
  }
}
