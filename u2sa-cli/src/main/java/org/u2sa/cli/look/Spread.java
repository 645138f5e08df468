package org.u2sa.cli.look;

import java.util.Arrays;

/** Statistics of the latest values of a quantity, at most 10,000. Not thread-safe. */
final class Spread {
  private static final int MOST = 10_000;

  private final double[] values = new double[MOST];
  private long count;

  void add(double value) {
    values[(int) (count++ % MOST)] = value;
  }

  /** Number of values so far, including dropped ones. */
  long count() {
    return count;
  }

  /**
   * Quantile of the kept values, by nearest rank.
   *
   * @param share the quantile's probability, 0…1
   * @throws IllegalStateException if there are no values
   */
  double quantile(double share) {
    double[] sorted = sorted();
    int rank = (int) Math.ceil(share * sorted.length);
    return sorted[Math.max(0, rank - 1)];
  }

  double mean() {
    return Arrays.stream(sorted()).average().orElseThrow();
  }

  /** Population standard deviation of the kept values. */
  double deviation() {
    double mean = mean();
    return Math.sqrt(
        Arrays.stream(sorted()).map(v -> (v - mean) * (v - mean)).average().orElseThrow());
  }

  private double[] sorted() {
    if (count == 0) {
      throw new IllegalStateException("no values yet");
    }
    double[] sorted = Arrays.copyOf(values, (int) Math.min(count, MOST));
    Arrays.sort(sorted);
    return sorted;
  }
}
