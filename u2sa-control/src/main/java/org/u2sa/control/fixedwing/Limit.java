package org.u2sa.control.fixedwing;

/** Clamping and angle wrapping. */
final class Limit {
  private static final double FULL_TURN = 2.0 * Math.PI;

  private Limit() {}

  /** Clamps a value to least…most. */
  static double within(double least, double value, double most) {
    return Math.max(least, Math.min(most, value));
  }

  /** Clamps a value to −bound…bound. */
  static double symmetric(double value, double bound) {
    return within(-bound, value, bound);
  }

  /** Moves from one value toward another by at most one step. */
  static double approach(double from, double to, double step) {
    return from + symmetric(to - from, step);
  }

  /** Wraps an angle to −π…π. */
  static double angle(double rad) {
    return StrictMath.IEEEremainder(rad, FULL_TURN);
  }
}
