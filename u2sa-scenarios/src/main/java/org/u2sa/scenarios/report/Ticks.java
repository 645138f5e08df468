package org.u2sa.scenarios.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Round numbers for an axis.
 *
 * @param step distance of neighbours: 1, 2 or 5 times a power of ten
 * @param values the multiples of it within the axis, ascending
 */
record Ticks(double step, List<Double> values) {

  /**
   * @param from least value of the axis
   * @param to greatest value, more than {@code from}
   * @param most how many ticks there is room for, 2 or more
   * @throws IllegalArgumentException if from, to and most are not so
   */
  static Ticks between(double from, double to, int most) {
    if (!(to > from) || most < 2) {
      throw new IllegalArgumentException("axis " + from + "…" + to + " with " + most + " ticks");
    }
    return every(stepFor((to - from) / most), from, to);
  }

  /** Ticks at the multiples of {@code step}. */
  static Ticks every(double step, double from, double to) {
    List<Double> values = new ArrayList<>();
    for (long i = (long) Math.ceil(from / step - 1e-9); i * step <= to + step * 1e-9; i++) {
      values.add(i * step);
    }
    return new Ticks(step, values);
  }

  /** The least round step (1, 2 or 5 times a power of ten) that is {@code least} or more. */
  static double stepFor(double least) {
    double power = Math.pow(10.0, Math.floor(Math.log10(least)));
    for (double factor : new double[] {1.0, 2.0, 5.0}) {
      if (factor * power >= least * (1.0 - 1e-9)) {
        return factor * power;
      }
    }
    return 10.0 * power;
  }

  /** {@code value} with just the decimals that the step needs. */
  String label(double value) {
    int decimals = Math.max(0, (int) -Math.floor(Math.log10(step) + 1e-9));
    return String.format(Locale.ROOT, "%." + decimals + "f", value + 0.0);
  }
}
