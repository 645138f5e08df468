package org.u2sa.control.allocation;

/** Solves linear equations by elimination with pivots: independent of the library under test. */
final class Gauss {
  private Gauss() {}

  static double[] solve(double[][] a, double[] b) {
    int n = b.length;
    double[][] m = new double[n][n + 1];
    for (int i = 0; i < n; i++) {
      System.arraycopy(a[i], 0, m[i], 0, n);
      m[i][n] = b[i];
    }
    for (int column = 0; column < n; column++) {
      int pivot = column;
      for (int row = column; row < n; row++) {
        pivot = Math.abs(m[row][column]) > Math.abs(m[pivot][column]) ? row : pivot;
      }
      double[] swapped = m[column];
      m[column] = m[pivot];
      m[pivot] = swapped;
      for (int row = 0; row < n; row++) {
        double factor = row == column ? 0.0 : m[row][column] / m[column][column];
        for (int k = column; k <= n; k++) {
          m[row][k] -= factor * m[column][k];
        }
      }
    }
    double[] x = new double[n];
    for (int i = 0; i < n; i++) {
      x[i] = m[i][n] / m[i][i];
    }
    return x;
  }
}
