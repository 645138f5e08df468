package org.u2sa.core.health;

import java.util.ArrayDeque;

/** Counts a service's recent restarts. */
final class RestartCount {
  private final ArrayDeque<Double> timesS = new ArrayDeque<>();
  private double lastS = Double.NEGATIVE_INFINITY;
  private long total;

  void add(double nowS) {
    timesS.add(nowS);
    lastS = nowS;
    total++;
  }

  /** Takes over a count of before. */
  void remember(long before) {
    total = Math.max(total, before);
  }

  /** Restarts within the window that ends now. */
  int within(double windowS, double nowS) {
    while (!timesS.isEmpty() && nowS - timesS.peek() > windowS) {
      timesS.poll();
    }
    return timesS.size();
  }

  /** When the newest was [s]; minus infinity without one. */
  double lastS() {
    return lastS;
  }

  /** All that were ever made. */
  long total() {
    return total;
  }
}
