package org.u2sa.core.control.ground;

/**
 * Motor commands of the two sides of a differential vehicle.
 *
 * @param left share of full, forward positive
 * @param right share of full, forward positive
 */
record WheelShares(double left, double right) {
  /** What both motors together ask for by what they can: more than 1 if one cannot. */
  double effort() {
    return Math.max(Math.abs(left), Math.abs(right));
  }

  /**
   * What the motors can do of it. One that drives ahead, or back, does so slower before it turns
   * less: it can be late, not beside its line. One that turns on the spot turns slower.
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
