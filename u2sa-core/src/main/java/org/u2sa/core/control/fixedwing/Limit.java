package org.u2sa.core.control.fixedwing;

/** Bounds on values, and angles brought into their range. */
final class Limit {
  private static final double FULL_TURN = 2.0 * Math.PI;

  private Limit() {}

  /** The value, moved into least…most. */
  static double within(double least, double value, double most) {
    return Math.max(least, Math.min(most, value));
  }

  /** The value, moved into −bound…bound. */
  static double symmetric(double value, double bound) {
    return within(-bound, value, bound);
  }

  /** From one value towards another, by at most a step. */
  static double approach(double from, double to, double step) {
    return from + symmetric(to - from, step);
  }

  /** An angle in −π…π. */
  static double angle(double rad) {
    return StrictMath.IEEEremainder(rad, FULL_TURN);
  }
}
