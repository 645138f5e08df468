package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.estimation.rotation.MotionHeading;
import org.u2sa.estimation.rotation.Quaternions;

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

  /** True accelerations turn to the right; the forces show them 1 rad too far to the right. */
  @Test
  void turnHeading_receiverShowsAnotherHeading_takesIt() {
    double north = 0.0;
    double east = 0.0;
    for (int i = 0; i < 100; i++) {
      double course = 0.07 * i;
      north += 0.2 * Math.cos(course);
      east += 0.2 * Math.sin(course);
      MotionHeading.accelerate(
          state.motion, 2.0 * Math.cos(course + 1.0), 2.0 * Math.sin(course + 1.0), 0.1);
      MotionHeading.velocity(state.motion, 0, north, east, 0.01);
    }
    state.trust[gps + SourceTrust.STREAK] = 2.0;
    assertThat(contradiction.isOfHeading(state, SensedQuantity.PLACE, gps)).isFalse();
    state.trust[gps + SourceTrust.STREAK] = 3.0;
    assertThat(contradiction.isOfHeading(state, SensedQuantity.PLACE, gps)).isTrue();

    contradiction.turnHeading(state);

    double[] r = new double[9];
    Quaternions.matrix(state.x, FilterState.Q, r);
    assertThat(Quaternions.psi(r)).isCloseTo(-1.0, within(0.05));
    assertThat(contradiction.isOfHeading(state, SensedQuantity.PLACE, gps)).isFalse();
    assertThat(MotionHeading.isFollowed(state.motion)).isTrue();
  }
}
