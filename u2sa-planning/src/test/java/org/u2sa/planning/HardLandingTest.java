package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Landing;

/** A multirotor at rest on the ground that may be damaged. */
class HardLandingTest extends VerticalFlight {
  private static Landing landing() {
    Landing landing = new Landing();
    landing.x(0.0).y(0.0).z(0.0);
    return landing;
  }

  /** As after the loss of the IMU: the estimate is level, but no longer measured. */
  @ParameterizedTest
  @CsvSource({"0.1, true", "0.6, false"})
  void landing_rollAndPitchOfThisSigma_isCompletedOnlyIfItMustBeUpright(
      double sigmaRad, boolean isCompleted) {
    start(10.0);
    tiltSigmaRad = sigmaRad;
    GoalInformation report = pursue(landing(), 60.0);

    assertThat(report.completed()).isEqualTo(isCompleted);
    if (!isCompleted) {
      assertThat(report.reason().orElseThrow()).contains("roll and pitch are unknown");
    }
  }

  /** As after a crash on the way to the landing, whose altitude nobody knows. */
  @ParameterizedTest
  @CsvSource({"0.1, false", "1.0, true"})
  void landing_crashesOnTheWay_isGivenUpUnlessItMustBeUpright(double sigmaRad, boolean isOver) {
    start(20.0);
    tiltSigmaRad = sigmaRad;
    Landing far = landing();
    far.x(8.0);
    begin(far);
    double beganS = kit.nowS();
    while (kit.nowS() < beganS + 15.0 && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      step(20.0);
    }

    assertThat(kit.latest(Channels.GOAL_REPORTS).isPresent()).isEqualTo(isOver);
    if (isOver) {
      GoalInformation report = kit.latest(Channels.GOAL_REPORTS).orElseThrow();
      assertThat(report.abandoned()).isTrue();
      assertThat(report.reason().orElseThrow())
          .isEqualTo("given up: may have tipped over, roll and pitch are unknown");
      assertThat(kit.nowS() - beganS).isGreaterThan(10.0);
    }
  }

  @Test
  void landing_fallsOntoThePlace_isNotReportedAsCompleted() {
    start(20.0);
    begin(landing());
    step(0.0);
    while (upM > 0.0) {
      double fallenM = upM - 0.8;
      step(0.0);
      upM = Math.max(0.0, fallenM);
    }
    while (kit.nowS() < 60.0 && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      step(0.0);
    }
    GoalInformation report = kit.latest(Channels.GOAL_REPORTS).orElseThrow();
    assertThat(report.abandoned()).isTrue();
    assertThat(report.reason().orElseThrow()).endsWith("hit the ground at 8 m/s");
  }
}
