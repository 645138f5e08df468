package org.u2sa.control.ground;

/**
 * Motor commands of the two sides of a differential vehicle.
 *
 * @param left fraction of full command, forward positive
 * @param right fraction of full command, forward positive
 */
record WheelShares(double left, double right) {
  /** Demand as a fraction of the motors' capability: more than 1 if one saturates. */
  double effort() {
    return Math.max(Math.abs(left), Math.abs(right));
  }

  /**
   * Limits the shares to attainable ones. While driving, speed is reduced before yaw rate, because
   * being late is better than leaving the line. A turn in place slows down.
   */
  WheelShares possible() {
    double ahead = 0.5 * (left + right);
    double slower = Math.min(Math.max(0.0, effort() - 1.0), Math.abs(ahead));
    WheelShares kept =
        new WheelShares(left - Math.copySign(slower, ahead), right - Math.copySign(slower, ahead));
    double most = Math.max(1.0, kept.effort());
    return new WheelShares(kept.left / most, kept.right / most);
  }
}
