package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class MotionWatchTest {
  private static final double STEP_S = 0.1;
  private static final Drive TURNS = new Drive(0.0, 1.0);
  private static final Drive DRIVES = new Drive(1.0, 0.0);
  private static final Drive REVERSES = new Drive(-1.0, 0.0);

  private final MotionWatch watch = new MotionWatch();

  private static GroundControl.Measured moves(double forwardMps, double yawRateRadPerS) {
    return new GroundControl.Measured(
        OptionalDouble.of(forwardMps), OptionalDouble.of(yawRateRadPerS));
  }

  /** The first words in that time. */
  private Optional<String> words(
      Drive demanded, GroundControl.Measured measured, double effort, double seconds) {
    for (int i = 0; i < Math.round(seconds / STEP_S); i++) {
      Optional<String> words = watch.see(demanded, measured, effort, 3.0, 10.0, STEP_S);
      if (words.isPresent()) {
        return words;
      }
    }
    return Optional.empty();
  }

  @Test
  void see_fullPowerThatDoesNotTurn_isSaidAndMotorsRest() {
    assertThat(words(TURNS, moves(0.0, 0.01), 1.0, 2.8)).isEmpty();
    assertThat(words(TURNS, moves(0.0, 0.01), 1.0, 0.3))
        .hasValue(
            "the motors cannot turn this load here: in 3.0 s at full power it turned by 2 degrees; they rest before the next attempt");
    assertThat(watch.rests(moves(0.0, 0.0), 9.5)).isTrue();
    assertThat(watch.rests(moves(0.0, 0.0), 1.0)).isFalse();
  }

  @Test
  void see_fullPowerThatTurnsOrIsNotNeeded_isNothing() {
    assertThat(words(TURNS, moves(0.0, 0.5), 1.0, 10.0)).isEmpty();
    assertThat(words(TURNS, moves(0.0, 0.0), 0.9, 10.0)).isEmpty();
    assertThat(words(TURNS, GroundControl.Measured.NOTHING, 1.0, 10.0)).isEmpty();
    assertThat(watch.rests(moves(0.0, 0.0), STEP_S)).isFalse();
  }

  @Test
  void see_reversesAtFullPower_isNothing() {
    assertThat(words(REVERSES, moves(-0.8, 0.0), 1.0, 10.0)).isEmpty();
    assertThat(watch.rests(moves(-0.8, 0.0), STEP_S)).isFalse();
  }

  @Test
  void see_fullPowerThatDoesNotReverse_isSaidAndMotorsRest() {
    assertThat(words(REVERSES, moves(-0.02, 0.0), 1.0, 3.2).orElseThrow())
        .contains("cannot move", "it went 0.06 m; they rest");
    assertThat(watch.rests(moves(0.0, 0.0), STEP_S)).isTrue();
  }

  @Test
  void see_rollsForwardWhileItReverses_isSaidAndMotorsGoOn() {
    assertThat(words(REVERSES, moves(0.2, 0.0), 1.0, 3.2).orElseThrow())
        .contains("at rest the vehicle would roll away");
  }

  @Test
  void see_rollsBackAtFullPower_isSaidAndMotorsGoOn() {
    assertThat(words(DRIVES, moves(-0.2, 0.0), 1.0, 3.2).orElseThrow())
        .contains("cannot move", "at rest the vehicle would roll away");
    assertThat(watch.rests(moves(-0.2, 0.0), STEP_S)).isFalse();
    assertThat(words(DRIVES, moves(-0.2, 0.0), 1.0, 8.0)).as("not every 3 s").isEmpty();
  }

  @Test
  void rests_rollsMeanwhile_motorsGoOn() {
    words(DRIVES, moves(0.0, 0.0), 1.0, 3.2);
    assertThat(watch.rests(moves(0.0, 0.0), STEP_S)).isTrue();

    assertThat(watch.rests(moves(-0.3, 0.0), STEP_S)).isFalse();
    assertThat(words(DRIVES, moves(0.0, 0.0), 1.0, 20.0).orElseThrow()).contains("they stay on");
  }
}
