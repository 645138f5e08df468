package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.service.handover.HandOver;

/** Whose words a Safety Manager that starts takes for those of the one before it. */
class PredecessorTest {
  private static final long START = 1_000_000_000; // µs
  private static final long HALF_A_SECOND = 500_000;
  private final Predecessor predecessor = new Predecessor(START, false);

  @BeforeEach
  void leaveState() {
    HandOver state = new HandOver("SafetyManager");
    Predecessor.handOver(state, true);
    predecessor.takeOver(state);
  }

  private static ArmingState armedAt(long micros) {
    ArmingState state = new ArmingState().armed(true);
    state.timestamp(micros);
    return state;
  }

  @ParameterizedTest
  @CsvSource({
    "-20000000, true",
    "-20000001, false",
    "0, true",
    "20000000, true",
    "20000001, false"
  })
  void see_wordsOfAnotherTime_countWithinTwentySecondsBeforeAndAhead(long micros, boolean counts) {
    predecessor.see(armedAt(START + micros), START);

    assertThat(predecessor.wasArmed()).isEqualTo(counts);
  }

  @ParameterizedTest
  @CsvSource({"-120000000, true", "-120000001, false"})
  void see_wordsBeforeARestart_countWithinTwoMinutes(long micros, boolean counts) {
    Predecessor before = new Predecessor(START, true);
    HandOver state = new HandOver("SafetyManager");
    Predecessor.handOver(state, true);
    before.takeOver(state);

    before.see(armedAt(START + micros), START);

    assertThat(before.wasArmed()).isEqualTo(counts);
  }

  @Test
  void see_wordsWithoutATime_doNotCount() {
    predecessor.see(new ArmingState().armed(true), START);

    assertThat(predecessor.wasArmed()).isFalse();
  }

  @Test
  void see_armedWordsWithoutSavedState_doNotCount() {
    Predecessor none = new Predecessor(START, false);
    none.see(armedAt(START), START);

    assertThat(none.wasArmed()).isFalse();
    assertThat(none.wasHeard()).isTrue();
  }

  /** As after a full disk: an aircraft must not be disarmed in the air. */
  @Test
  void see_armedWordsBeforeARestartWithoutSavedState_count() {
    Predecessor lost = new Predecessor(START, true);
    lost.see(armedAt(START), START);

    assertThat(lost.wasArmed()).isTrue();
    lost.end();
    assertThat(lost.wasArmed()).isFalse();
  }

  @Test
  void isAwaited_forHalfASecond_andNothingCountsAfterwards() {
    assertThat(predecessor.isAwaited(START + HALF_A_SECOND - 1)).isTrue();
    assertThat(predecessor.isAwaited(START + HALF_A_SECOND)).isFalse();
    assertThat(predecessor.isAwaited(START)).as("a clock that went back").isFalse();

    predecessor.see(armedAt(START), START);
    assertThat(predecessor.wasArmed()).isFalse();
  }

  @Test
  void end_afterItWasHeard_forgetsWhatItSaid() {
    assertThat(predecessor.wasHeard()).isFalse();
    predecessor.see(armedAt(START), START);
    assertThat(predecessor.wasArmed()).isTrue();

    predecessor.end();

    assertThat(predecessor.wasArmed()).isFalse();
    assertThat(predecessor.isAwaited(START)).isFalse();
  }
}
