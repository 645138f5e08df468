package org.u2sa.estimation.fusion;

import java.util.Arrays;

/**
 * Sparse transition matrix F of the error state over a step: the identity except for a few elements
 * (4 % are nonzero). P ← F P Fᵀ processes only these and exploits the symmetry of P. Diagonal-only
 * rows of states that are not estimated, and so have no variance, are skipped.
 */
final class Transition {
  private static final int N = FilterState.N;

  private final int[][] columns = new int[N][N]; // of a row's nonzero elements, ascending
  private final double[][] values = new double[N][N];
  private final int[] sizes = new int[N];
  private final int[] changed = new int[N]; // rows that differ from the identity, ascending
  private int changes;
  private final double[] product = new double[N * N];

  /** Resets it to the identity. */
  void reset() {
    Arrays.fill(sizes, 1);
    for (int row = 0; row < N; row++) {
      columns[row][0] = row;
      values[row][0] = 1.0;
    }
  }

  /** Sets an element. */
  void set(int row, int column, double value) {
    int[] of = columns[row];
    int at = sizes[row];
    while (at > 0 && of[at - 1] >= column) {
      at--;
    }
    if (at == sizes[row] || of[at] != column) {
      System.arraycopy(of, at, of, at + 1, sizes[row] - at);
      System.arraycopy(values[row], at, values[row], at + 1, sizes[row] - at);
      of[at] = column;
      sizes[row]++;
    }
    values[row][at] = value;
  }

  /** Computes P ← F P Fᵀ for a symmetric P. */
  void carry(double[] p) {
    changes = 0;
    for (int row = 0; row < N; row++) {
      boolean isScaled = values[row][0] != 1.0 && p[row * N + row] != 0.0;
      if (sizes[row] > 1 || isScaled) {
        changed[changes++] = row;
      }
    }
    for (int c = 0; c < changes; c++) {
      combineRows(p, changed[c]);
    }
    for (int c = 0; c < changes; c++) {
      int row = changed[c];
      System.arraycopy(product, row * N, p, row * N, N);
      for (int k = 0; k < N; k++) {
        p[k * N + row] = product[row * N + k];
      }
    }
    for (int c = 0; c < changes; c++) {
      combineColumns(p, c);
    }
  }

  /** Stores a row of F P in the product. */
  private void combineRows(double[] p, int row) {
    int to = row * N;
    double first = values[row][0];
    int fromFirst = columns[row][0] * N;
    for (int k = 0; k < N; k++) {
      product[to + k] = 0.0 + first * p[fromFirst + k]; // + 0.0: no negative zero
    }
    for (int n = 1; n < sizes[row]; n++) {
      double factor = values[row][n];
      int from = columns[row][n] * N;
      for (int k = 0; k < N; k++) {
        product[to + k] += factor * p[from + k];
      }
    }
  }

  /** Computes a row of (F P) Fᵀ in the columns that change, and the symmetric column. */
  private void combineColumns(double[] p, int change) {
    int row = changed[change];
    int from = row * N;
    for (int c = 0; c <= change; c++) {
      int column = changed[c];
      int[] of = columns[column];
      double[] by = values[column];
      double sum = 0.0;
      for (int n = 0; n < sizes[column]; n++) {
        sum += by[n] * product[from + of[n]];
      }
      p[from + column] = sum;
      p[column * N + row] = sum;
    }
  }
}
