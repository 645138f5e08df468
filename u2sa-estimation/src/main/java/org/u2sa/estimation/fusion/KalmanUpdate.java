package org.u2sa.estimation.fusion;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.u2sa.estimation.delay.InertialPath;
import org.u2sa.estimation.rotation.MotionHeading;
import org.u2sa.estimation.rotation.Quaternions;

/**
 * Updates state and covariance with one measurement vector. The covariance update is in Joseph
 * form, written for a gain K and G = P Hᵀ: P - K Gᵀ - G Kᵀ + K S Kᵀ, which stays positive definite
 * despite rounding of K (Bucy and Joseph 1968). Only nonzero columns of H and rows of G are
 * processed, and only the lower half of the symmetric covariance.
 */
final class KalmanUpdate {
  private static final int N = FilterState.N;

  private final double[][] g = new double[3][N]; // columns of G
  private final double[][] k = new double[3][N]; // columns of K
  private final double[][] excess = new double[3][N]; // columns of K S - G: rounding of K
  private final DMatrixRMaj s = new DMatrixRMaj(3, 3);
  private final DMatrixRMaj inverse = new DMatrixRMaj(3, 3);
  private final double[] dx = new double[N];
  private final int[] used = new int[N]; // nonzero columns of H, ascending
  private final int[] touched = new int[N]; // nonzero rows of G, ascending
  private int uses;
  private int touches;
  private int rows;

  /** Variance of each component due to the state's uncertainty: diagonal of H P Hᵀ. */
  final double[] expected = new double[3];

  /**
   * Computes gain inputs and innovation statistics of a measurement.
   *
   * @param factor factor on the claimed variances
   * @return normalised innovation squared, χ² distributed with as many degrees of freedom as rows
   */
  double prepare(FilterState state, Linearization m, double factor) {
    rows = m.rows;
    s.reshape(rows, rows);
    inverse.reshape(rows, rows);
    findUsed(m.h.data);
    project(state.p.data, m.h.data);
    for (int i = 0; i < rows; i++) {
      for (int j = 0; j < rows; j++) {
        double sum = 0.0;
        for (int c = 0; c < uses; c++) {
          sum += m.h.data[i * N + used[c]] * g[j][used[c]];
        }
        s.data[i * rows + j] = sum;
      }
      expected[i] = s.data[i * rows + i];
    }
    return weigh(m, factor);
  }

  private void findUsed(double[] h) {
    uses = 0;
    for (int column = 0; column < N; column++) {
      for (int row = 0; row < rows; row++) {
        if (h[row * N + column] != 0.0) {
          used[uses++] = column;
          break;
        }
      }
    }
  }

  /** G = P Hᵀ. */
  private void project(double[] p, double[] h) {
    for (int row = 0; row < rows; row++) {
      double[] column = g[row];
      Arrays.fill(column, 0.0);
      for (int c = 0; c < uses; c++) {
        double factor = h[row * N + used[c]];
        int from = used[c] * N; // P is symmetric; rows are contiguous
        for (int i = 0; i < N; i++) {
          column[i] += factor * p[from + i];
        }
      }
    }
    findTouched();
  }

  private void findTouched() {
    touches = 0;
    for (int i = 0; i < N; i++) {
      boolean isTouched = false;
      for (int row = 0; row < rows; row++) {
        isTouched |= g[row][i] != 0.0;
      }
      if (isTouched) {
        touched[touches++] = i;
      }
    }
  }

  /** Repeats {@link #prepare} for the same measurement with another factor. */
  double weigh(Linearization m, double factor) {
    for (int i = 0; i < rows; i++) {
      s.data[i * rows + i] = expected[i] + factor * m.variance[i];
    }
    CommonOps_DDRM.invert(s, inverse);
    double nis = 0.0;
    for (int i = 0; i < rows; i++) {
      for (int j = 0; j < rows; j++) {
        nis += m.innovation[i] * inverse.data[i * rows + j] * m.innovation[j];
      }
    }
    return nis;
  }

  /** Applies the prepared update to the state. */
  void apply(FilterState state, Linearization m) {
    Arrays.fill(dx, 0.0);
    boolean isDelayObservable = DelayErrors.isObservable(state);
    for (int a = 0; a < touches; a++) {
      int i = touched[a];
      boolean isDelay = i >= FilterState.DELAY && i < FilterState.DELAY + FilterState.DELAY_SLOTS;
      boolean isCorrected =
          !isDelay || isDelayObservable && !state.isDelayShown[i - FilterState.DELAY];
      for (int c = 0; c < rows; c++) {
        k[c][i] = isCorrected ? product(g, i, inverse.data, c) : 0.0;
        dx[i] += k[c][i] * m.innovation[c];
      }
      for (int c = 0; c < rows; c++) {
        excess[c][i] = product(k, i, s.data, c) - g[c][i];
      }
    }
    change(state.p.data);
    constrain(state);
    correct(state);
  }

  /**
   * Projects the correction onto valid delays along the covariance (estimate projection, Simon
   * 2010): clamping only the delay would attribute its part of the innovation to other states.
   */
  private void constrain(FilterState state) {
    for (int slot = 0; slot < FilterState.DELAY_SLOTS; slot++) {
      int delay = FilterState.DELAY + slot;
      double seconds = state.x[FilterState.DELAYS + slot] + dx[delay];
      double over = seconds - DelayErrors.possible(seconds);
      if (over != 0.0 && DelayErrors.isEstimated(state, slot)) {
        double by = over / state.variance(delay);
        for (int i = 0; i < N; i++) {
          dx[i] -= by * state.p.data[delay * N + i];
        }
      }
    }
  }

  /** Element of the product of a column-major matrix and a square matrix. */
  private double product(double[][] columns, int row, double[] square, int column) {
    double sum = 0.0;
    for (int c = 0; c < rows; c++) {
      sum += columns[c][row] * square[c * rows + column];
    }
    return sum;
  }

  /**
   * Adds (K S - G) Kᵀ - K Gᵀ to the lower triangle, component after component in each element, and
   * mirrors it.
   */
  private void change(double[] p) {
    double[] g0 = g[0];
    double[] g1 = g[1];
    double[] g2 = g[2];
    double[] k0 = k[0];
    double[] k1 = k[1];
    double[] k2 = k[2];
    for (int a = 0; a < touches; a++) {
      int i = touched[a];
      int from = i * N;
      double k0i = k0[i];
      double r0i = excess[0][i];
      double k1i = k1[i];
      double r1i = excess[1][i];
      double k2i = k2[i];
      double r2i = excess[2][i];
      for (int b = 0; b <= a; b++) {
        int j = touched[b];
        double value = p[from + j] + (r0i * k0[j] - k0i * g0[j]);
        if (rows > 1) {
          value += r1i * k1[j] - k1i * g1[j];
        }
        if (rows > 2) {
          value += r2i * k2[j] - k2i * g2[j];
        }
        p[from + j] = value;
        p[j * N + i] = value;
      }
    }
  }

  private void correct(FilterState state) {
    double[] x = state.x;
    state.move(dx[0], dx[1], dx[2]);
    for (int i = 0; i < 3; i++) {
      x[FilterState.V + i] += dx[FilterState.VELOCITY + i];
      x[FilterState.BG + i] += dx[FilterState.GYRO_BIAS + i];
      x[FilterState.BF + i] += dx[FilterState.FORCE_BIAS + i];
      x[FilterState.W + i] += dx[FilterState.RATE + i];
      x[FilterState.SPEED_ERROR + i] += dx[FilterState.SPEED_BIAS + i];
      if (state.isInertial) {
        x[FilterState.W + i] -= dx[FilterState.GYRO_BIAS + i];
      }
    }
    Quaternions.turnEarth(
        x,
        FilterState.Q,
        dx[FilterState.ATTITUDE],
        dx[FilterState.ATTITUDE + 1],
        dx[FilterState.ATTITUDE + 2]);
    MotionHeading.corrected(state.motion, dx[FilterState.ATTITUDE + 2]);
    InertialPath.corrected(state.path, dx[FilterState.ATTITUDE + 2]);
    x[FilterState.FLOW_NORTH] += dx[FilterState.FLOW];
    x[FilterState.FLOW_NORTH + 1] += dx[FilterState.FLOW + 1];
    x[FilterState.WHEEL_SCALE] += dx[FilterState.SCALE];
    x[FilterState.LOG_TURN] += dx[FilterState.LOG_YAW];
    for (int i = 0; i < FilterState.PERSISTENT_STATES; i++) {
      x[FilterState.PERSISTENT_ERRORS + i] += dx[FilterState.PERSISTENT + i];
    }
    for (int i = 0; i < FilterState.DELAY_SLOTS; i++) {
      if (!state.isDelayShown[i]) {
        double seconds = x[FilterState.DELAYS + i] + dx[FilterState.DELAY + i];
        x[FilterState.DELAYS + i] = DelayErrors.possible(seconds);
      }
    }
  }
}
