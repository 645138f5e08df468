package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.RandomMatrices_DDRM;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The correction of one half against full matrices. */
class KalmanUpdateTest {
  private static final int N = FilterState.N;
  private static final int ABSENT = 12; // an error that is not estimated

  private final Random random = new Random(11);
  private final KalmanUpdate update = new KalmanUpdate();
  private final FilterState state = new FilterState();
  private final Linearization model = new Linearization();

  private void begin(int rows) {
    DMatrixRMaj root = RandomMatrices_DDRM.rectangle(N, N, -1.0, 1.0, random);
    for (int k = 0; k < N; k++) {
      root.set(ABSENT, k, 0.0);
    }
    CommonOps_DDRM.multTransB(root, root, state.p);
    model.rows = rows;
    model.h.reshape(rows, N);
    CommonOps_DDRM.fill(model.h, 0.0);
    for (int row = 0; row < rows; row++) {
      for (int i = 0; i < 4; i++) {
        model.h.set(row, random.nextInt(N), random.nextGaussian());
      }
      model.variance[row] = 0.1 + random.nextDouble();
      model.innovation[row] = random.nextGaussian();
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void apply_anyMeasurement_isTheCorrectionByFullMatrices(int rows) {
    for (int run = 0; run < 30; run++) {
      begin(rows);
      state.isStrapdown = true;
      state.x[FilterState.STEADY_V] = 1e3;
      state.x[FilterState.V] = 2e3; // a change by which delays are corrected, too
      DMatrixRMaj g = new DMatrixRMaj(N, rows);
      CommonOps_DDRM.multTransB(state.p, model.h, g);
      DMatrixRMaj s = new DMatrixRMaj(rows, rows);
      CommonOps_DDRM.mult(model.h, g, s);
      for (int i = 0; i < rows; i++) {
        s.add(i, i, 2.0 * model.variance[i]);
      }
      DMatrixRMaj inverse = s.copy();
      CommonOps_DDRM.invert(inverse);
      DMatrixRMaj k = new DMatrixRMaj(N, rows);
      CommonOps_DDRM.mult(g, inverse, k);
      DMatrixRMaj expected = state.p.copy();
      CommonOps_DDRM.multAddTransB(-1.0, k, g, expected);
      double nis = 0.0;
      for (int i = 0; i < rows; i++) {
        for (int j = 0; j < rows; j++) {
          nis += model.innovation[i] * inverse.get(i, j) * model.innovation[j];
        }
      }
      double north = state.x[FilterState.NORTH];
      double moved = 0.0;
      for (int c = 0; c < rows; c++) {
        moved += k.get(FilterState.POSITION, c) * model.innovation[c];
      }

      assertThat(update.prepare(state, model, 2.0)).isCloseTo(nis, within(1e-9));
      update.apply(state, model);

      assertThat(state.x[FilterState.NORTH] - north).isCloseTo(moved, within(1e-9));
      for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
          assertThat(state.p.get(i, j))
              .as("number %d, %d", i, j)
              .isCloseTo(expected.get(i, j), within(1e-10))
              .isEqualTo(state.p.get(j, i));
        }
      }
    }
  }

  /** Of any gain K, (I - K H) P (I - K H)ᵀ + K R Kᵀ; here that of delays is 0. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void apply_steadyMotion_considersDelaysWithoutCorrectingThem(int rows) {
    begin(rows);
    DMatrixRMaj g = new DMatrixRMaj(N, rows);
    CommonOps_DDRM.multTransB(state.p, model.h, g);
    DMatrixRMaj s = new DMatrixRMaj(rows, rows);
    CommonOps_DDRM.mult(model.h, g, s);
    for (int i = 0; i < rows; i++) {
      s.add(i, i, model.variance[i]);
    }
    DMatrixRMaj inverse = s.copy();
    CommonOps_DDRM.invert(inverse);
    DMatrixRMaj k = new DMatrixRMaj(N, rows);
    CommonOps_DDRM.mult(g, inverse, k);
    for (int i = FilterState.DELAY; i < FilterState.SPEED_BIAS; i++) {
      for (int c = 0; c < rows; c++) {
        k.set(i, c, 0.0);
      }
    }
    DMatrixRMaj left = CommonOps_DDRM.identity(N);
    CommonOps_DDRM.multAdd(-1.0, k, model.h, left);
    DMatrixRMaj half = new DMatrixRMaj(N, N);
    CommonOps_DDRM.mult(left, state.p, half);
    DMatrixRMaj expected = new DMatrixRMaj(N, N);
    CommonOps_DDRM.multTransB(half, left, expected);
    for (int c = 0; c < rows; c++) {
      for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
          expected.add(i, j, k.get(i, c) * model.variance[c] * k.get(j, c));
        }
      }
    }

    update.prepare(state, model, 1.0);
    update.apply(state, model);

    assertThat(state.x[FilterState.DELAYS]).isZero();
    for (int i = 0; i < N; i++) {
      for (int j = 0; j < N; j++) {
        assertThat(state.p.get(i, j)).isCloseTo(expected.get(i, j), within(1e-9));
      }
    }
  }
}
