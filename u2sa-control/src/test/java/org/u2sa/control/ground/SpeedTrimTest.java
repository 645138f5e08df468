package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SpeedTrimTest {
  private static final double MAX_MPS = 2.0;
  private static final Drive DRIVES = new Drive(1.0, 0.0);
  private static final Drive TURNS = new Drive(0.0, 0.5);

  private final SpeedTrim trim = new SpeedTrim();

  private double after(double seconds, Drive demanded, OptionalDouble errorMps) {
    return after(seconds, demanded, errorMps, false);
  }

  private double after(
      double seconds, Drive demanded, OptionalDouble errorMps, boolean atFullPower) {
    double answer = 0.0;
    for (int i = 0; i < seconds * 10.0; i++) {
      answer = trim.step(demanded, errorMps, atFullPower, 0.2, MAX_MPS, 0.1);
    }
    return answer;
  }

  @Test
  void step_slowerThanDemanded_demandsMoreUpToWhatTheMotorsCan() {
    assertThat(after(1.0, DRIVES, OptionalDouble.of(0.2))).isBetween(0.03, 0.05);
    assertThat(after(100.0, DRIVES, OptionalDouble.of(0.2)))
        .isCloseTo(MAX_MPS - 1.0, within(1.0e-9));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1.0, -1.0})
  void step_atFullPower_windsNothingUpAndStillGivesWay(double direction) {
    Drive demanded = new Drive(direction, 0.0);
    double before = direction * after(1.0, demanded, OptionalDouble.of(0.2 * direction));

    assertThat(direction * after(10.0, demanded, OptionalDouble.of(0.2 * direction), true))
        .isEqualTo(before);
    assertThat(direction * after(0.1, demanded, OptionalDouble.of(-0.2 * direction), true))
        .isLessThan(before);
  }

  @Test
  void step_downhill_mayReverseTheMotors() {
    assertThat(after(100.0, DRIVES, OptionalDouble.of(-0.5)))
        .isCloseTo(-MAX_MPS - 1.0, within(1.0e-9));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1.0, -1.0})
  void step_toSlowDownALoadedVehicle_drivesOnInProportionOnly(double direction) {
    double before = after(5.0, new Drive(direction, 0.0), OptionalDouble.of(0.5 * direction));

    double after = after(0.1, new Drive(0.25 * direction, 0.0), OptionalDouble.of(0.0));

    assertThat(before * direction).isGreaterThan(0.4);
    assertThat(after).isCloseTo(0.25 * before, within(1.0e-9));
  }

  @Test
  void step_toSlowDownDownhill_holdsBackAsBefore() {
    double before = after(5.0, DRIVES, OptionalDouble.of(-0.5));

    assertThat(before).isLessThan(-0.4);
    assertThat(after(0.1, new Drive(0.25, 0.0), OptionalDouble.of(0.0))).isEqualTo(before);
  }

  @Test
  void step_speedUnknown_staysAsItIs() {
    double before = after(1.0, DRIVES, OptionalDouble.of(0.2));

    assertThat(after(10.0, DRIVES, OptionalDouble.empty())).isEqualTo(before);
  }

  @Test
  void step_standing_isNone() {
    after(10.0, DRIVES, OptionalDouble.of(0.5));

    assertThat(after(0.1, Drive.STANDING, OptionalDouble.of(0.1))).isZero();
  }

  @Test
  void step_fromDrivingToATurnOnTheSpot_beginsAnew() {
    after(10.0, DRIVES, OptionalDouble.of(0.5));

    assertThat(after(0.1, TURNS, OptionalDouble.of(0.1))).isCloseTo(0.002, within(1.0e-9));
    assertThat(after(1.0, TURNS, OptionalDouble.of(0.1))).isPositive();
  }

  @Test
  void step_changeOfDirection_forgetsTheTrim() {
    after(10.0, new Drive(-1.0, 0.0), OptionalDouble.of(-0.3));

    assertThat(after(0.1, DRIVES, OptionalDouble.of(0.0))).isZero();
  }

  @Test
  void step_feedbackSwitchedOff_forgetsTheTrim() {
    assertThat(after(0.2, DRIVES, OptionalDouble.of(0.2))).isPositive();

    assertThat(trim.step(DRIVES, OptionalDouble.of(0.2), false, 0.0, MAX_MPS, 0.1)).isZero();
  }
}
