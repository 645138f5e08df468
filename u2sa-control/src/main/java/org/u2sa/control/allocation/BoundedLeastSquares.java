package org.u2sa.control.allocation;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/**
 * Solves min ½ xᵀ H x − gᵀ x within lowest ≤ x ≤ highest, H positive definite, exactly.
 *
 * <p>It starts like a redistributed pseudo-inverse (Bodson: Evaluation of Optimization Methods for
 * Control Allocation, JGCD 25 (2002) 4): unknowns that saturate are held at their bounds, and the
 * others compensate. Where that would end short of the optimum, a bound whose multiplier has the
 * wrong sign is released again (active set; Härkegård: Efficient active set algorithms for solving
 * constrained least squares problems in aircraft control allocation, CDC 2002; Nocedal &amp;
 * Wright, algorithm 16.3). Allocates no memory while solving. Not thread-safe.
 */
final class BoundedLeastSquares {
  private static final double RELATIVE_SLACK = 1e-10; // tolerance of multipliers
  private static final int ROUNDS_PER_UNKNOWN = 6;

  private final int size;
  private final double[] x;
  private final double[] direction;
  private final byte[] held; // −1 at the lowest, 1 at the highest, 0 free
  private final int[] free;
  private final DMatrixRMaj matrix;
  private final DMatrixRMaj right;
  private final DMatrixRMaj solution;
  private final LinearSolverDense<DMatrixRMaj> solver;

  BoundedLeastSquares(int size) {
    this.size = size;
    x = new double[size];
    direction = new double[size];
    held = new byte[size];
    free = new int[size];
    matrix = new DMatrixRMaj(size, size);
    right = new DMatrixRMaj(size, 1);
    solution = new DMatrixRMaj(size, 1);
    solver = LinearSolverFactory_DDRM.chol(size);
  }

  /**
   * Solves.
   *
   * @param h symmetric, positive definite
   * @return the solution, valid until the next call
   */
  double[] solve(double[][] h, double[] g, double[] lowest, double[] highest) {
    double scale = 0.0;
    for (int i = 0; i < size; i++) {
      x[i] = Math.max(lowest[i], Math.min(highest[i], 0.0));
      held[i] = 0;
      scale = Math.max(scale, Math.abs(g[i]));
    }
    double slack = RELATIVE_SLACK * scale;
    for (int round = 0; round < ROUNDS_PER_UNKNOWN * size; round++) {
      int count = freeUnknowns();
      towardsOptimum(h, g, count);
      if (!advance(lowest, highest, count) && !release(h, g, slack)) {
        break;
      }
    }
    return x;
  }

  private int freeUnknowns() {
    int count = 0;
    for (int i = 0; i < size; i++) {
      if (held[i] == 0) {
        free[count++] = i;
      }
    }
    return count;
  }

  /** Computes the step to the optimum of the free unknowns, with the others fixed. */
  private void towardsOptimum(double[][] h, double[] g, int count) {
    if (count == 0) {
      return;
    }
    matrix.reshape(count, count);
    right.reshape(count, 1);
    solution.reshape(count, 1);
    for (int row = 0; row < count; row++) {
      int i = free[row];
      for (int column = 0; column < count; column++) {
        matrix.data[row * count + column] = h[i][free[column]];
      }
      right.data[row] = -gradient(h, g, i);
    }
    if (!solver.setA(matrix)) {
      throw new IllegalStateException("H is not positive definite");
    }
    solver.solve(right, solution);
    for (int row = 0; row < count; row++) {
      direction[free[row]] = solution.data[row];
    }
  }

  private double gradient(double[][] h, double[] g, int i) {
    double sum = -g[i];
    for (int j = 0; j < size; j++) {
      sum += h[i][j] * x[j];
    }
    return sum;
  }

  /** Moves the free unknowns until the first reaches its bound; returns whether one did. */
  private boolean advance(double[] lowest, double[] highest, int count) {
    double share = 1.0;
    int first = -1;
    for (int row = 0; row < count; row++) {
      int i = free[row];
      double room = (direction[i] > 0.0 ? highest[i] : lowest[i]) - x[i];
      if (direction[i] != 0.0 && Math.abs(room) < share * Math.abs(direction[i])) {
        share = Math.abs(room / direction[i]);
        first = i;
      }
    }
    for (int row = 0; row < count; row++) {
      int i = free[row];
      x[i] = Math.max(lowest[i], Math.min(highest[i], x[i] + share * direction[i]));
    }
    if (first >= 0) {
      boolean up = direction[first] > 0.0;
      x[first] = up ? highest[first] : lowest[first];
      held[first] = (byte) (up ? 1 : -1);
    }
    return first >= 0;
  }

  /** Releases the bound with the worst multiplier; returns whether one was released. */
  private boolean release(double[][] h, double[] g, double slack) {
    int worst = -1;
    double most = slack;
    for (int i = 0; i < size; i++) {
      double cost = held[i] * gradient(h, g, i);
      if (held[i] != 0 && cost > most) {
        most = cost;
        worst = i;
      }
    }
    if (worst >= 0) {
      held[worst] = 0;
    }
    return worst >= 0;
  }
}
