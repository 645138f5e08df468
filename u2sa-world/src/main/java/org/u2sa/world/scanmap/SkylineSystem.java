package org.u2sa.world.scanmap;

import java.util.Arrays;

/**
 * Sparse symmetric positive definite system in envelope storage, solved by Cholesky's method
 * (George and Liu, "Computer solution of large sparse positive definite systems", 1981, section
 * 4.2). A chain of poses has short rows; each loop closure lengthens one.
 */
final class SkylineSystem {
  private final int[] first; // column of the first element of each row
  private final double[][] rows;

  /**
   * @param first column of the first element of each row that may be non-zero
   */
  SkylineSystem(int[] first) {
    this.first = first.clone();
    rows = new double[first.length][];
    for (int i = 0; i < first.length; i++) {
      rows[i] = new double[i - first[i] + 1];
    }
  }

  /** Adds to an element of the lower triangle. */
  void add(int row, int column, double value) {
    rows[row][column - first[row]] += value;
  }

  /** Replaces the matrix by its Cholesky factor. */
  void factor() {
    for (int i = 0; i < rows.length; i++) {
      double[] a = rows[i];
      for (int j = first[i]; j < i; j++) {
        double[] b = rows[j];
        int from = Math.max(first[i], first[j]);
        double sum = a[j - first[i]];
        for (int k = from; k < j; k++) {
          sum -= a[k - first[i]] * b[k - first[j]];
        }
        a[j - first[i]] = sum / b[j - first[j]];
      }
      double square = a[i - first[i]];
      for (int k = 0; k < i - first[i]; k++) {
        square -= a[k] * a[k];
      }
      if (!(square > 0.0)) {
        throw new ArithmeticException("not positive definite in row " + i);
      }
      a[i - first[i]] = Math.sqrt(square);
    }
  }

  /** Solves for a right-hand side, after {@link #factor}. */
  double[] solve(double[] right) {
    double[] x = Arrays.copyOf(right, right.length);
    for (int i = 0; i < x.length; i++) {
      for (int k = first[i]; k < i; k++) {
        x[i] -= rows[i][k - first[i]] * x[k];
      }
      x[i] /= rows[i][i - first[i]];
    }
    for (int i = x.length - 1; i >= 0; i--) {
      x[i] /= rows[i][i - first[i]];
      for (int k = first[i]; k < i; k++) {
        x[k] -= rows[i][k - first[i]] * x[i];
      }
    }
    return x;
  }
}
