package org.u2sa.core.control.ground;

/**
 * How a ground vehicle is to move.
 *
 * @param speedMps forwards [m/s]
 * @param yawRateRadPerS [rad/s], to the left positive
 */
record Drive(double speedMps, double yawRateRadPerS) {
  /** At rest. */
  static final Drive STANDING = new Drive(0.0, 0.0);

  boolean isStanding() {
    return speedMps == 0.0 && yawRateRadPerS == 0.0;
  }
}
