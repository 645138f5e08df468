package org.u2sa.estimation.fusion;

import org.ejml.data.DMatrixRMaj;

/**
 * A measurement vector linearised about the state: one row per measured component, with prediction,
 * innovation, claimed variance, and Jacobian with respect to the error state.
 */
final class Linearization {
  private static final int N = FilterState.N;

  /** Jacobian; only the first {@link #rows} rows are valid. */
  final DMatrixRMaj h = new DMatrixRMaj(3, N);

  final double[] innovation = new double[3];
  final double[] variance = new double[3];
  final double[] predicted = new double[3];
  int rows;

  /** Removes all rows. */
  void clear() {
    h.reshape(3, N);
    h.zero();
    rows = 0;
  }

  /** Sets an element of the Jacobian in the next row. */
  void set(int column, double value) {
    set(rows, column, value);
  }

  /** Sets an element of the Jacobian in the last row. */
  void setLast(int column, double value) {
    set(rows - 1, column, value);
  }

  /** Sets an element of the Jacobian. */
  void set(int row, int column, double value) {
    h.data[row * N + column] = value;
  }

  /** Completes the next row. */
  void row(double measured, double expected, double sigma) {
    predicted[rows] = expected;
    innovation[rows] = measured - expected;
    variance[rows] = sigma * sigma;
    rows++;
  }

  /** Shifts the prediction of the last row. */
  void shift(double more, double addedVariance) {
    innovation[rows - 1] -= more;
    predicted[rows - 1] += more;
    variance[rows - 1] += addedVariance;
  }

  /** Multiplies the prediction of the last row by a factor from the state, given its column. */
  void scale(double factor, int column) {
    double unscaled = predicted[rows - 1];
    for (int k = 0; k < N; k++) {
      h.data[(rows - 1) * N + k] *= factor;
    }
    setLast(column, unscaled);
    shift((factor - 1.0) * unscaled, 0.0);
  }

  /** Standard deviation of a row's prediction due to the state's uncertainty. */
  double sigma(FilterState s, int row) {
    double sum = 0.0;
    for (int i = 0; i < N; i++) {
      double hi = h.data[row * N + i];
      if (hi != 0.0) {
        for (int k = 0; k < N; k++) {
          sum += hi * s.p.data[i * N + k] * h.data[row * N + k];
        }
      }
    }
    return Math.sqrt(Math.max(0.0, sum));
  }
}
