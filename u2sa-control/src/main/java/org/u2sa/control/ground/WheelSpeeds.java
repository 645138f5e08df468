package org.u2sa.control.ground;

/**
 * Ground speeds of the two sides of a differential vehicle.
 *
 * @param leftMps forward speed [m/s]
 * @param rightMps forward speed [m/s]
 */
record WheelSpeeds(double leftMps, double rightMps) {

  /**
   * Wheel speeds of a motion; if a wheel exceeds its limit, both are scaled by the same factor, so
   * that the vehicle stays on its arc.
   *
   * @param trackM track width [m]
   * @param mostMps maximum wheel speed [m/s]
   */
  static WheelSpeeds of(Drive drive, double trackM, double mostMps) {
    double half = drive.yawRateRadPerS() * trackM / 2.0; // to the left: the right side is faster
    double left = drive.speedMps() - half;
    double right = drive.speedMps() + half;
    double share = Math.min(1.0, mostMps / Math.max(Math.abs(left), Math.abs(right)));
    return new WheelSpeeds(share * left, share * right);
  }

  /** Motion of the vehicle at these wheel speeds. */
  Drive drive(double trackM) {
    return new Drive((leftMps + rightMps) / 2.0, (rightMps - leftMps) / trackM);
  }
}
