package org.u2sa.core.estimation.fusion;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * Corrects state and covariance by one measurement vector. The covariance is updated in Joseph's
 * form, written out for a gain K and G = P Hᵀ: P - K Gᵀ - G Kᵀ + K S Kᵀ, which stays positive
 * whatever the rounding of K (Bucy and Joseph 1968).
 */
final class KalmanUpdate {
  private static final int N = FilterState.N;

  private final DMatrixRMaj g = new DMatrixRMaj(N, 3);
  private final DMatrixRMaj k = new DMatrixRMaj(N, 3);
  private final DMatrixRMaj ks = new DMatrixRMaj(N, 3);
  private final DMatrixRMaj s = new DMatrixRMaj(3, 3);
  private final DMatrixRMaj inverse = new DMatrixRMaj(3, 3);
  private final double[][] gains = new double[3][N]; // columns of K
  private final double[][] shared = new double[3][N]; // columns of G
  private final double[] sum = new double[N];
  private final double[] dx = new double[N];
  private final int[] columns = new int[N]; // of error states that are concerned
  private int rows;

  /** Variance of each component by the state's own uncertainty: diagonal of H P Hᵀ. */
  final double[] expected = new double[3];

  /**
   * Prepares for a measurement.
   *
   * @param factor by which the claimed variances are multiplied
   * @return normalised innovation squared, χ² distributed with as many degrees of freedom as rows
   */
  double prepare(FilterState state, MeasurementModel m, double factor) {
    rows = m.rows;
    m.h.reshape(rows, N);
    g.reshape(N, rows);
    s.reshape(rows, rows);
    inverse.reshape(rows, rows);
    project(state.p.data, m.h.data);
    CommonOps_DDRM.mult(m.h, g, s);
    for (int i = 0; i < rows; i++) {
      expected[i] = s.data[i * rows + i];
    }
    return weigh(m, factor);
  }

  /** G = P Hᵀ, from the columns of H that are not 0. */
  private void project(double[] p, double[] h) {
    int used = 0;
    for (int column = 0; column < N; column++) {
      for (int row = 0; row < rows; row++) {
        if (h[row * N + column] != 0.0) {
          columns[used++] = column;
          break;
        }
      }
    }
    for (int i = 0; i < N; i++) {
      for (int row = 0; row < rows; row++) {
        double sum = 0.0;
        for (int c = 0; c < used; c++) {
          sum += p[i * N + columns[c]] * h[row * N + columns[c]];
        }
        g.data[i * rows + row] = sum;
      }
    }
  }

  /** {@link #prepare} with another factor, for the same measurement. */
  double weigh(MeasurementModel m, double factor) {
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

  /** Corrects the state by what was prepared. */
  void apply(FilterState state, MeasurementModel m) {
    k.reshape(N, rows);
    ks.reshape(N, rows);
    CommonOps_DDRM.mult(g, inverse, k);
    CommonOps_DDRM.mult(k, s, ks);
    int touched = 0;
    for (int i = 0; i < N; i++) {
      dx[i] = 0.0;
      boolean isTouched = false;
      for (int c = 0; c < rows; c++) {
        gains[c][i] = k.data[i * rows + c];
        shared[c][i] = g.data[i * rows + c];
        isTouched |= g.data[i * rows + c] != 0.0;
        dx[i] += k.data[i * rows + c] * m.innovation[c];
      }
      if (isTouched) {
        columns[touched++] = i;
      }
    }
    double[] p = state.p.data;
    for (int a = 0; a < touched; a++) {
      change(p, columns[a]);
    }
    for (int a = 1; a < touched; a++) {
      for (int b = 0; b < a; b++) {
        int here = columns[a] * N + columns[b];
        int there = columns[b] * N + columns[a];
        double mean = 0.5 * (p[here] + p[there]);
        p[here] = mean;
        p[there] = mean;
      }
    }
    correct(state);
  }

  /**
   * Adds a row of K S Kᵀ - K Gᵀ - G Kᵀ: rows of arrays, which the compiler takes several at once.
   */
  private void change(double[] p, int i) {
    Arrays.fill(sum, 0.0);
    for (int c = 0; c < rows; c++) {
      double[] kc = gains[c];
      double[] gc = shared[c];
      double ksi = ks.data[i * rows + c];
      double ki = kc[i];
      double gi = gc[i];
      for (int j = 0; j < N; j++) {
        sum[j] += ksi * kc[j] - ki * gc[j] - gi * kc[j];
      }
    }
    for (int j = 0; j < N; j++) {
      p[i * N + j] += sum[j];
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
    x[FilterState.FLOW_NORTH] += dx[FilterState.FLOW];
    x[FilterState.FLOW_NORTH + 1] += dx[FilterState.FLOW + 1];
    x[FilterState.WHEEL_SCALE] += dx[FilterState.SCALE];
    for (int i = 0; i < PersistentErrors.STATES; i++) {
      x[FilterState.PERSISTENT_ERRORS + i] += dx[FilterState.PERSISTENT + i];
    }
    for (int i = 0; i < DelayErrors.SLOTS; i++) {
      x[FilterState.DELAYS + i] += dx[FilterState.DELAY + i];
    }
  }
}
