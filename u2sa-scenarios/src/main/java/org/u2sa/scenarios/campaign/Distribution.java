package org.u2sa.scenarios.campaign;

import java.util.Arrays;
import java.util.stream.DoubleStream;

/**
 * How a figure is spread over runs. Quantiles lie between the two nearest values by linear
 * interpolation (type 7 of Hyndman and Fan, "Sample quantiles in statistical packages", 1996).
 *
 * @param values in ascending order, at least one
 */
record Distribution(double[] values) {
  /** Of values in any order, at least one. */
  static Distribution of(DoubleStream values) {
    return new Distribution(values.sorted().toArray());
  }

  /** The value that a share of all [0…1] does not exceed. */
  double quantile(double share) {
    double at = share * (values.length - 1);
    int below = (int) Math.floor(at);
    int above = Math.min(values.length - 1, below + 1);
    return values[below] + (at - below) * (values[above] - values[below]);
  }

  /** The middle. */
  double median() {
    return quantile(0.5);
  }

  /** Arithmetic mean. */
  double mean() {
    return Arrays.stream(values).average().orElseThrow();
  }

  /** The least. */
  double least() {
    return values[0];
  }

  /** The greatest. */
  double greatest() {
    return values[values.length - 1];
  }

  /** Whether all are the same. */
  boolean isConstant() {
    return least() == greatest();
  }
}
