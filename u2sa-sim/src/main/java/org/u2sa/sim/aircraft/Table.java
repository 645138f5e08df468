package org.u2sa.sim.aircraft;

/** Piecewise-linear function through given points, constant beyond the ends. */
final class Table {
  private final double[] x;
  private final double[] y;

  /**
   * @param pairs x, y, x, y … with x ascending
   */
  Table(double... pairs) {
    x = new double[pairs.length / 2];
    y = new double[pairs.length / 2];
    for (int i = 0; i < x.length; i++) {
      x[i] = pairs[2 * i];
      y[i] = pairs[2 * i + 1];
    }
  }

  double at(double value) {
    int last = x.length - 1;
    if (!(value > x[0])) {
      return y[0];
    }
    if (value >= x[last]) {
      return y[last];
    }
    int i = 1;
    while (value > x[i]) {
      i++;
    }
    return y[i - 1] + (y[i] - y[i - 1]) * (value - x[i - 1]) / (x[i] - x[i - 1]);
  }
}
