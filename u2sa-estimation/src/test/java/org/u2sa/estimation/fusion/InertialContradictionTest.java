package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.estimation.measurement.SensedQuantity;

/** A receiver and the motors contradict an estimate that an encoder of the wrong scale supports. */
class InertialContradictionTest {
  private final FilterTuning tuning = FilterTuning.of(MotionDomain.GROUND);
  private final SourceTrust trust = new SourceTrust(tuning.window());
  private final InertialContradiction contradiction = new InertialContradiction(tuning, trust);
  private final FilterState state = new FilterState();
  private final int gps = at("GPS", SensedQuantity.PLACE);
  private final int motors = at("Motors", SensedQuantity.BODY_VELOCITY);
  private final int encoder = at("Encoder", SensedQuantity.BODY_VELOCITY);

  private int at(String source, SensedQuantity quantity) {
    return trust.of(state, trust.source(source), quantity);
  }

  private void refuse(int at) {
    state.trust[at + SourceTrust.STREAK] = 5.0;
    state.trust[at + SourceTrust.STREAK_SINCE] = 9_000_000;
  }

  @Test
  void admit_speedThatSupportedTheWrongEstimate_isDoubtedAndTheOthersAreNot() {
    state.micros = 10_000_000;
    state.isStrapdown = true;
    state.x[FilterState.V] = 1.2;
    refuse(gps);
    refuse(motors);
    state.trust[encoder + SourceTrust.LAST_USED] = 9_990_000;
    assertThat(contradiction.isShown(state)).isTrue();

    contradiction.admit(state);

    assertThat(state.trust[encoder + SourceTrust.DOUBT_MPS]).isEqualTo(1.2);
    assertThat(state.trust[encoder + SourceTrust.IS_BIASED]).isEqualTo(1.0);
    assertThat(state.trust[motors + SourceTrust.DOUBT_MPS]).isZero();
    assertThat(state.trust[motors + SourceTrust.STREAK]).isZero();
    assertThat(contradiction.isShown(state)).isFalse();
  }
}
