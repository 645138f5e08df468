package org.u2sa.core.control.ground;

/**
 * Speeds of the two sides of a differential vehicle over ground.
 *
 * @param leftMps forwards [m/s]
 * @param rightMps forwards [m/s]
 */
record WheelSpeeds(double leftMps, double rightMps) {

  /**
   * What the wheels do in a motion; if a wheel cannot turn so fast, both are slowed by the same
   * share, so that the vehicle stays on its arc.
   *
   * @param trackM between the wheels of both sides [m]
   * @param mostMps that a wheel can do [m/s]
   */
  static WheelSpeeds of(Drive drive, double trackM, double mostMps) {
    double half = drive.yawRateRadPerS() * trackM / 2.0; // to the left: the right side is faster
    double left = drive.speedMps() - half;
    double right = drive.speedMps() + half;
    double share = Math.min(1.0, mostMps / Math.max(Math.abs(left), Math.abs(right)));
    return new WheelSpeeds(share * left, share * right);
  }

  /** The motion that the wheels make. */
  Drive drive(double trackM) {
    return new Drive((leftMps + rightMps) / 2.0, (rightMps - leftMps) / trackM);
  }
}
