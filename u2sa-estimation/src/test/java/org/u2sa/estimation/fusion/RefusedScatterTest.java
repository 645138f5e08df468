package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Positions that were refused: which of them show that their source's claim is wrong. */
class RefusedScatterTest {
  private static final double CLAIMED = 0.01; // variance [m²]
  private static final double NOISE_M = 2.0;

  private final Random random = new Random(3);
  private final RefusedScatter scatter = new RefusedScatter(FilterTuning.of(MotionDomain.GROUND));
  private final Linearization model = new Linearization();
  private final FilterState s = new FilterState();
  private int refusals;

  @BeforeEach
  void begin() {
    s.trust = new double[100];
    model.rows = 2;
    model.variance[0] = CLAIMED;
    model.variance[1] = CLAIMED;
  }

  private boolean isBeyondClaimAfter(double north, double east) {
    s.trust[SourceTrust.STREAK] = ++refusals;
    model.innovation[0] = north;
    model.innovation[1] = east;
    RefusedScatter.note(s.trust, model, 0);
    return scatter.isBeyondClaim(s, model, 0, true);
  }

  private double noise() {
    return NOISE_M * random.nextGaussian();
  }

  @Test
  void isBeyondClaim_noiseBesideTheEstimate_factorAndUncertaintyAreOfTheNoise() {
    for (int i = 0; i < 4; i++) {
      assertThat(isBeyondClaimAfter(20.0 + noise(), noise())).isFalse();
    }
    assertThat(isBeyondClaimAfter(20.0 + noise(), noise())).isTrue();
    double shown = NOISE_M * NOISE_M;
    assertThat(SourceTrust.factor(s, 0) * CLAIMED).isBetween(shown / 3.0, 3.0 * shown);
    assertThat(s.variance(FilterState.POSITION)).isBetween(shown / 3.0, 3.0 * shown);
    assertThat(s.trust[SourceTrust.STREAK]).isZero();
  }

  @Test
  void isBeyondClaim_walksAway_speedIsWrong() {
    for (int i = 0; i < 30; i++) {
      assertThat(isBeyondClaimAfter(5.0 + 2.0 * i, -0.5 * i + 0.02 * noise())).isFalse();
    }
  }

  @Test
  void isBeyondClaim_jumps_positionIsWrong() {
    for (int i = 0; i < 30; i++) {
      assertThat(isBeyondClaimAfter(i < 10 ? 5.0 : 20.0, 0.02 * noise())).isFalse();
    }
  }
}
