package org.u2sa.core.planning;

/** Arithmetic of directions. */
final class Angles {
  private Angles() {}

  /** The same direction in -π…π [rad]. */
  static double wrapped(double angleRad) {
    return Math.IEEEremainder(angleRad, 2.0 * Math.PI);
  }
}
