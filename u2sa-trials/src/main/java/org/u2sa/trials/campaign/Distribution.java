package org.u2sa.trials.campaign;

import java.util.Arrays;
import java.util.stream.DoubleStream;

/**
 * Distribution of a metric over runs. Quantiles are interpolated linearly (type 7 of Hyndman and
 * Fan, "Sample quantiles in statistical packages", 1996).
 *
 * @param values in ascending order, at least one
 */
record Distribution(double[] values) {
  /** Distribution of at least one value, in any order. */
  static Distribution of(DoubleStream values) {
    return new Distribution(values.sorted().toArray());
  }

  /** The quantile of a fraction [0…1]. */
  double quantile(double share) {
    double at = share * (values.length - 1);
    int below = (int) Math.floor(at);
    int above = Math.min(values.length - 1, below + 1);
    return values[below] + (at - below) * (values[above] - values[below]);
  }

  double median() {
    return quantile(0.5);
  }

  /** Arithmetic mean. */
  double mean() {
    return Arrays.stream(values).average().orElseThrow();
  }

  /** Minimum. */
  double least() {
    return values[0];
  }

  /** Maximum. */
  double greatest() {
    return values[values.length - 1];
  }

  /** Whether all values are equal. */
  boolean isConstant() {
    return least() == greatest();
  }
}
