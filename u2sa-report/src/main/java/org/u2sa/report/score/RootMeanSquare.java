package org.u2sa.report.score;

import java.util.OptionalDouble;

/**
 * RMS over time of a quantity that is linear between its samples, so that uneven sampling does not
 * bias it.
 */
final class RootMeanSquare {
  private double squareSeconds;
  private double seconds;
  private double largest;

  /** Adds a linear change from {@code from} to {@code to} in {@code durationS}. */
  void add(double durationS, double from, double to) {
    squareSeconds +=
        durationS * (from * from + from * to + to * to) / 3.0; // ∫ of a squared linear function
    seconds += durationS;
    largest = Math.max(largest, Math.max(Math.abs(from), Math.abs(to)));
  }

  /** RMS; empty without values. */
  OptionalDouble value() {
    return seconds > 0.0
        ? OptionalDouble.of(Math.sqrt(squareSeconds / seconds))
        : OptionalDouble.empty();
  }

  /** Maximum absolute value; empty without values. */
  OptionalDouble largest() {
    return seconds > 0.0 ? OptionalDouble.of(largest) : OptionalDouble.empty();
  }
}
