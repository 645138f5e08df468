package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.estimation.measurement.SensedQuantity;

/** Who may speak against an inertial sensor. */
class SourceJudgeTest {
  private final FilterTuning tuning = FilterTuning.of(MotionDomain.GROUND);
  private final SourceTrust trust = new SourceTrust(tuning.window());
  private final SourceJudge judge = new SourceJudge(tuning, trust);
  private final FilterState state = new FilterState();
  private final int imu = trust.source("IMU");
  private final int gps = trust.source("GPS");

  private void refuseThreeFixes() {
    int at = trust.of(state, gps, SensedQuantity.PLACE);
    state.micros = 10_000_000;
    state.trust[at + SourceTrust.STREAK] = 3.0;
    int own = trust.of(state, gps);
    state.trust[own + SourceTrust.LAST_MICROS] = state.micros;
    state.trust[own + SourceTrust.INTERVAL] = 0.2;
  }

  @Test
  void isContradicted_fixesAreRefused_othersMayBeWrong() {
    refuseThreeFixes();
    assertThat(judge.isContradicted(state, imu)).isTrue();
    assertThat(judge.isContradicted(state, gps)).isFalse();
  }

  @Test
  void isContradicted_refusedSourceFellSilent_speaksNoLonger() {
    refuseThreeFixes();
    state.micros += 1_100_000;
    assertThat(judge.isContradicted(state, imu)).isFalse();
  }

  @Test
  void leavesOutFrozen_sourceThatWasRefused_speaksNoLonger() {
    refuseThreeFixes();
    int at = trust.of(state, gps, SensedQuantity.PLACE);
    assertThat(judge.leavesOutFrozen(state, gps, at)).isFalse();
    assertThat(judge.isContradicted(state, imu)).isTrue();

    state.trust[trust.of(state, gps) + SourceTrust.IS_FROZEN] = 1.0;
    assertThat(judge.leavesOutFrozen(state, gps, at)).isTrue();
    assertThat(judge.isContradicted(state, imu)).isFalse();
    assertThat(state.trust[at + SourceTrust.GATED]).isEqualTo(1.0);
  }
}
