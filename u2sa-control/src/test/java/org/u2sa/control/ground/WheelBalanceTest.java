package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** On a plant without inertia: yaw rate by the difference of what the wheels do. */
class WheelBalanceTest {
  private static final double STEP_S = 0.05;
  private static final double SHARE_PER_RADPS = 0.1;
  private static final WheelBalance.Settings SETTINGS =
      new WheelBalance.Settings(0.0, 0.15, 1.0, 2.0, 0.8, SHARE_PER_RADPS, 1.0, 1.0);
  private static final WheelShares AHEAD = new WheelShares(0.5, 0.5);
  private static final WheelShares LEFT_TURN = new WheelShares(-0.2, 0.2);
  private static final WheelShares STANDING = new WheelShares(0.0, 0.0);

  private final WheelBalance balance = new WheelBalance();
  private double yawRate;

  /** Drives with motors so far apart that both need a share to move at all. */
  private WheelShares drive(
      WheelShares wanted, double ahead, double mismatch, double stiction, double seconds) {
    WheelShares told = wanted;
    double demanded = (wanted.right() - wanted.left()) / 2.0 / SHARE_PER_RADPS;
    for (int i = 0; i < seconds / STEP_S; i++) {
      told = balance.step(wanted, ahead, OptionalDouble.of(demanded - yawRate), SETTINGS, STEP_S);
      double left = moved((1.0 - mismatch) * told.left(), stiction);
      double right = moved((1.0 + mismatch) * told.right(), stiction);
      yawRate = (right - left) / 2.0 / SHARE_PER_RADPS;
    }
    return told;
  }

  private static double moved(double share, double stiction) {
    return Math.copySign(Math.max(0.0, Math.abs(share) - stiction), share);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-0.5, -0.3, 0.0, 0.05, 0.3, 0.5})
  void step_motorsThatAreNotAlike_driveStraight(double mismatch) {
    drive(AHEAD, 0.5, mismatch, 0.0, 10.0);

    assertThat(yawRate).isCloseTo(0.0, within(0.02));
  }

  @ParameterizedTest
  @ValueSource(doubles = {-0.5, -0.3, 0.0, 0.05, 0.3, 0.5})
  void step_motorsThatAreNotAlike_reverseStraight(double mismatch) {
    drive(new WheelShares(-0.5, -0.5), -0.5, mismatch, 0.0, 10.0);

    assertThat(yawRate).isCloseTo(0.0, within(0.02));
  }

  @Test
  void step_reversesAfterAPushedTurn_isNotPushed() {
    drive(LEFT_TURN, 0.0, 0.0, 0.4, 5.0);
    WheelShares arc = new WheelShares(-0.42, -0.38);
    WheelShares told = balance.step(arc, -0.4, OptionalDouble.of(0.0), SETTINGS, STEP_S);

    assertThat(told.left()).isCloseTo(arc.left(), within(0.01));
    assertThat(told.right()).isCloseTo(arc.right(), within(0.01));
  }

  @Test
  void step_feedbackSwitchedOff_commandsByCalibrationAlone() {
    drive(AHEAD, 0.5, 0.3, 0.0, 10.0);
    drive(LEFT_TURN, 0.0, 0.3, 0.1, 5.0);
    WheelBalance.Settings off =
        new WheelBalance.Settings(0.0, 0.15, 0.0, 0.0, 0.8, SHARE_PER_RADPS, 1.0, 1.0);

    assertThat(balance.step(AHEAD, 0.5, OptionalDouble.of(0.5), off, STEP_S)).isEqualTo(AHEAD);
    assertThat(balance.step(LEFT_TURN, 0.0, OptionalDouble.of(0.5), off, STEP_S))
        .isEqualTo(LEFT_TURN);
  }

  @Test
  void step_standingMeanwhile_keepsWhatItLearnedAndCommandsNothing() {
    WheelShares learned = drive(AHEAD, 0.5, 0.3, 0.0, 10.0);

    assertThat(balance.step(STANDING, 0.0, OptionalDouble.of(0.5), SETTINGS, STEP_S))
        .isEqualTo(STANDING);
    WheelShares again = balance.step(AHEAD, 0.5, OptionalDouble.empty(), SETTINGS, STEP_S);
    assertThat(again.left() / again.right())
        .isCloseTo(learned.left() / learned.right(), within(0.15));
  }

  @Test
  void step_loadThatHoldsTheWheels_isPushedRoundAndAtOnceTheNextTime() {
    drive(LEFT_TURN, 0.0, 0.0, 0.4, 5.0);
    assertThat(yawRate).isCloseTo(2.0, within(0.1));

    balance.step(STANDING, 0.0, OptionalDouble.empty(), SETTINGS, STEP_S);
    yawRate = 0.0;
    drive(new WheelShares(0.2, -0.2), 0.0, 0.0, 0.4, 2.0 * STEP_S);
    assertThat(yawRate).isCloseTo(-2.0, within(0.3));
  }

  @Test
  void step_loadThatCannotBeTurned_asksForAllAndWindsNothingUp() {
    WheelShares told = drive(LEFT_TURN, 0.0, 0.0, 5.0, 60.0);

    assertThat(told.effort()).isCloseTo(1.0, within(1.0e-9));
    balance.relax();
    assertThat(balance.step(LEFT_TURN, 0.0, OptionalDouble.empty(), SETTINGS, STEP_S))
        .isEqualTo(LEFT_TURN);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-9.0, 2.0, 9.0}) // as if the vehicle turned too fast, not at all, or back
  void step_measuredYawRateIsWrong_turnsInPlaceWithinTheLimit(double error) {
    WheelBalance.Settings bounded =
        new WheelBalance.Settings(2.0, 0.15, 1.0, 2.0, 0.8, SHARE_PER_RADPS, 1.2, 0.4);
    WheelShares told = LEFT_TURN;
    for (int i = 0; i < 200; i++) {
      told = balance.step(LEFT_TURN, 0.0, OptionalDouble.of(error), bounded, STEP_S);
      assertThat(told.effort()).isLessThanOrEqualTo(0.4 + 1.0e-9);
    }
    for (int i = 0; i < 20; i++) {
      told = balance.step(LEFT_TURN, 0.0, OptionalDouble.of(0.0), bounded, STEP_S);
    }
    WheelShares next = balance.step(LEFT_TURN, 0.0, OptionalDouble.of(-2.0), bounded, STEP_S);
    assertThat(next.right()).isLessThan(told.right()); // nothing has wound up
  }

  @Test
  void step_measuredYawRateIsWrongWhileDriving_proportionalPartIsBounded() {
    WheelBalance.Settings bounded =
        new WheelBalance.Settings(2.0, 0.15, 0.0, 0.0, 0.8, SHARE_PER_RADPS, 1.2, 0.4);
    WheelShares told = AHEAD;
    for (int i = 0; i < 100; i++) {
      told = balance.step(AHEAD, 0.5, OptionalDouble.of(3.0), bounded, STEP_S);
    }

    assertThat(told.right() - 0.5).isCloseTo(0.12, within(1.0e-9));
  }

  @Test
  void step_mismatchBeyondItsLimit_staysWithin() {
    WheelShares told = drive(AHEAD, 0.5, 0.95, 0.0, 100.0);

    assertThat(told.possible().effort()).isLessThanOrEqualTo(1.0);
    assertThat(told.right()).isLessThan(0.2 * told.left());
  }
}
