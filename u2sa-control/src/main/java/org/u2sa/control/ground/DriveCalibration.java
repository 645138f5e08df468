package org.u2sa.control.ground;

/**
 * Maps ground speed to motor command as a fraction of full command: below the start command,
 * friction and the motor controller's dead band hold the vehicle; above it, speed grows linearly.
 *
 * @param maxMps speed at full command [m/s]
 * @param startShare share at which the vehicle starts to move, 0…1
 */
record DriveCalibration(double maxMps, double startShare) {
  private static final double STANDS_MPS = 1.0e-6;

  /** Command for a speed [m/s]: −1…1 for attainable speeds, 0 at standstill. */
  double share(double mps) {
    if (Math.abs(mps) < STANDS_MPS) {
      return 0.0;
    }
    return Math.copySign(startShare + (1.0 - startShare) * Math.abs(mps) / maxMps, mps);
  }

  /** Speed at a command [m/s]. */
  double speedMps(double share) {
    double moving = Math.max(0.0, Math.abs(share) - startShare) / (1.0 - startShare);
    return Math.copySign(moving * maxMps, share);
  }
}
