package org.u2sa.device.wheel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

/** Speeds and their signs from counts. */
class WheelOdometryTest {
  private static final double NEAR = 1.0e-9;
  private final WheelOdometry odometry = new WheelOdometry(0.001, 0.5, 0.03, 10.0);

  private Optional<StateInformation> after(double seconds, int left, int right) {
    odometry.reset();
    odometry.moved(0, 0, 0);
    return odometry.moved(Math.round(seconds * 1.0e6), left, right);
  }

  @Test
  void moved_bothWheelsAlike_isStraight() {
    StateInformation state = after(0.1, 200, 200).orElseThrow();
    assertThat(state.referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(state.xDot().getAsDouble()).isCloseTo(2.0, within(NEAR));
    assertThat(state.yDot()).hasValue(0.0);
    assertThat(state.psiDot().getAsDouble()).isCloseTo(0.0, within(NEAR));
    assertThat(state.xDotSigma().getAsDouble()).isCloseTo(0.06 / Math.sqrt(2.0), within(0.001));
  }

  @Test
  void moved_rightWheelForwardLeftBack_turnsLeftWhichIsPositiveInBody() {
    StateInformation state = after(0.1, -25, 25).orElseThrow();
    assertThat(state.xDot().getAsDouble()).isCloseTo(0.0, within(NEAR));
    assertThat(state.psiDot().getAsDouble()).isCloseTo(1.0, within(NEAR)); // 0.5 m/s over 0.5 m
  }

  /** Else the estimate lags by half a span wherever the speed changes. */
  @Test
  void moved_aSpan_isAMeanOfTheTimeInItsMiddle() {
    assertThat(after(0.1, 200, 200).orElseThrow().timestamp()).hasValue(50_000L);
  }

  @Test
  void moved_countersWrap_goesOn() {
    odometry.moved(0, Integer.MAX_VALUE - 50, Integer.MIN_VALUE + 50);
    StateInformation state =
        odometry.moved(100_000, Integer.MIN_VALUE + 49, Integer.MAX_VALUE - 49).orElseThrow();
    assertThat(state.psiDot().getAsDouble()).isCloseTo(-4.0, within(NEAR));
  }

  @Test
  void moved_firstOrSameTimeOrImpossible_saysNothing() {
    assertThat(odometry.moved(0, 5, 5)).isEmpty();
    assertThat(odometry.moved(0, 6, 6)).isEmpty();
    assertThat(odometry.moved(100_000, 1_000_000, 6)).as("faster than 10 m/s").isEmpty();
    assertThat(odometry.moved(200_000, 1_000_100, 106)).isPresent();
  }
}
