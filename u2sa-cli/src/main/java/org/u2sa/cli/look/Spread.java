package org.u2sa.cli.look;

import java.util.Arrays;

/**
 * The newest values of a quantity, at most 10,000 of them, and what they are like. Belongs to one
 * thread at a time.
 */
final class Spread {
  private static final int MOST = 10_000;

  private final double[] values = new double[MOST];
  private long count;

  void add(double value) {
    values[(int) (count++ % MOST)] = value;
  }

  /** Values so far, those no longer kept included. */
  long count() {
    return count;
  }

  /**
   * The value below or at which that share of the kept ones is; the nearest rank.
   *
   * @param share 0…1
   * @throws IllegalStateException if there are none
   */
  double quantile(double share) {
    double[] sorted = sorted();
    int rank = (int) Math.ceil(share * sorted.length);
    return sorted[Math.max(0, rank - 1)];
  }

  double mean() {
    return Arrays.stream(sorted()).average().orElseThrow();
  }

  /** Standard deviation of the kept values, as of a whole population. */
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
