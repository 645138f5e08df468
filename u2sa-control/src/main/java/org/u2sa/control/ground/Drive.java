package org.u2sa.control.ground;

/**
 * Motion command of a ground vehicle.
 *
 * @param speedMps forward speed [m/s]
 * @param yawRateRadPerS yaw rate [rad/s], left positive
 */
record Drive(double speedMps, double yawRateRadPerS) {
  /** At rest. */
  static final Drive STANDING = new Drive(0.0, 0.0);

  boolean isStanding() {
    return speedMps == 0.0 && yawRateRadPerS == 0.0;
  }
}
