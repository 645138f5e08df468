package org.u2sa.core.control.ground;

/**
 * What the motors of the two sides of a differential vehicle are commanded.
 *
 * @param left share of all that the motor can, forwards positive
 * @param right share of all that the motor can, forwards positive
 */
record WheelShares(double left, double right) {
  /** What both motors together ask for by what they can: more than 1 if one cannot. */
  double effort() {
    return Math.max(Math.abs(left), Math.abs(right));
  }

  /** Both less by the same share if one motor cannot do so much, so that the arc stays. */
  WheelShares possible() {
    double most = Math.max(1.0, effort());
    return new WheelShares(left / most, right / most);
  }
}
