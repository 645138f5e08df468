package org.u2sa.scenarios.report;

import java.util.OptionalDouble;

/**
 * Root of the mean square over time of a quantity that runs straight between its samples, so that
 * uneven sampling weighs nothing wrongly.
 */
final class RootMeanSquare {

  private double squareSeconds;
  private double seconds;
  private double largest;

  /** The quantity went from {@code from} to {@code to} in {@code durationS}. */
  void add(double durationS, double from, double to) {
    squareSeconds +=
        durationS * (from * from + from * to + to * to) / 3.0; // ∫ of a squared straight line
    seconds += durationS;
    largest = Math.max(largest, Math.max(Math.abs(from), Math.abs(to)));
  }

  /** Empty if nothing was added. */
  OptionalDouble value() {
    return seconds > 0.0
        ? OptionalDouble.of(Math.sqrt(squareSeconds / seconds))
        : OptionalDouble.empty();
  }

  /** Largest absolute value; empty if nothing was added. */
  OptionalDouble largest() {
    return seconds > 0.0 ? OptionalDouble.of(largest) : OptionalDouble.empty();
  }
}
