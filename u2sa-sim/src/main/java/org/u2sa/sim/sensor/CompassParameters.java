package org.u2sa.sim.sensor;

import org.u2sa.sim.motion.Arguments;

/**
 * A two-axis magnetometer on a level vehicle, with what its calibration left over.
 *
 * @param rateHz headings in a second
 * @param declinationRad magnetic north, east of true north [rad]
 * @param horizontalUt the earth's horizontal field [µT]
 * @param hardForwardUt field of the vehicle's own magnets, along it [µT]
 * @param hardRightUt to the right [µT]
 * @param softForward by which iron strengthens the field along the vehicle
 * @param softRight across it
 * @param softCross by which a field along gives one across, and the other way round
 * @param forwardUtPerA of each motor's current, along the vehicle [µT/A]
 * @param rightUtPerA of the left motor's current to the right; the right one's is opposite [µT/A]
 * @param noiseUt of each axis and reading [µT]
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
   * A calibrated smart compass as Sparton's SP3004D: 0.3° of noise, half a degree that calibration
   * left, another half for 10 A in the motors. The field is that of the eastern United States.
   */
  public static CompassParameters calibrated(double declinationRad) {
    return new CompassParameters(
        20.0, declinationRad, 21.0, 0.12, -0.15, 0.004, -0.003, 0.003, 0.004, 0.01, 0.1);
  }

  /** A telephone's magnetometer beside the motors: several degrees of everything. */
  public static CompassParameters phone(double declinationRad) {
    return new CompassParameters(
        20.0, declinationRad, 21.0, 1.2, -1.5, 0.03, -0.04, 0.02, 0.03, 0.05, 0.5);
  }

  /** One without error. */
  public static CompassParameters perfect(double declinationRad) {
    return new CompassParameters(20.0, declinationRad, 21.0, 0, 0, 0, 0, 0, 0, 0, 0);
  }
}
