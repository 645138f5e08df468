package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.RandomMatrices_DDRM;
import org.junit.jupiter.api.Test;

/** The sparse transition against full matrices. */
class TransitionTest {
  private static final int N = FilterState.N;

  private final Random random = new Random(7);
  private final Transition transition = new Transition();
  private final DMatrixRMaj f = new DMatrixRMaj(N, N);

  private void set(int row, int column, double value) {
    transition.set(row, column, value);
    f.set(row, column, value);
  }

  private void assertCarries() {
    DMatrixRMaj p = RandomMatrices_DDRM.symmetric(N, -1.0, 1.0, random);
    DMatrixRMaj half = new DMatrixRMaj(N, N);
    DMatrixRMaj expected = new DMatrixRMaj(N, N);
    CommonOps_DDRM.mult(f, p, half);
    CommonOps_DDRM.multTransB(half, f, expected);
    transition.carry(p.data);
    for (int i = 0; i < N * N; i++) {
      assertThat(p.data[i]).as("number %d", i).isCloseTo(expected.data[i], within(1e-12));
    }
  }

  @Test
  void carry_anyNumbersInAnyOrder_isTheProductOfFullMatrices() {
    for (int run = 0; run < 50; run++) {
      transition.reset();
      CommonOps_DDRM.setIdentity(f);
      for (int i = 0; i < 40; i++) {
        set(random.nextInt(N), random.nextInt(N), random.nextGaussian());
      }
      assertCarries();
    }
  }

  @Test
  void carry_anyNumbers_leavesHalvesEqualToTheLastBit() {
    transition.reset();
    for (int i = 0; i < 40; i++) {
      transition.set(random.nextInt(N), random.nextInt(N), random.nextGaussian());
    }
    DMatrixRMaj p = RandomMatrices_DDRM.symmetric(N, -1.0, 1.0, random);
    transition.carry(p.data);
    for (int i = 0; i < N; i++) {
      for (int k = 0; k < i; k++) {
        assertThat(p.get(i, k)).as("number %d, %d", i, k).isEqualTo(p.get(k, i));
      }
    }
  }

  @Test
  void carry_numberSetTwice_theSecondCounts() {
    transition.reset();
    CommonOps_DDRM.setIdentity(f);
    set(3, 7, 5.0);
    set(3, 7, -2.0);
    set(4, 4, 0.5);
    assertCarries();
  }

  @Test
  void carry_scaleOfWhatHasNoVariance_changesNothing() {
    transition.reset();
    transition.set(5, 5, 0.5);
    DMatrixRMaj p = CommonOps_DDRM.identity(N);
    p.set(5, 5, 0.0);
    DMatrixRMaj before = p.copy();
    transition.carry(p.data);
    assertThat(p.data).isEqualTo(before.data);
  }

  @Test
  void reset_afterUse_isTheIdentity() {
    transition.reset();
    transition.set(0, N - 1, 3.0);
    transition.set(N - 1, 0, 3.0);
    transition.reset();
    CommonOps_DDRM.setIdentity(f);
    assertCarries();
  }
}
