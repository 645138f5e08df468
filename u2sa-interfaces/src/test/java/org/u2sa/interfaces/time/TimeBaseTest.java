package org.u2sa.interfaces.time;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Processes of one machine whose time of day somebody sets while they run. */
class TimeBaseTest {
  private static final long HOUR_MILLIS = 3_600_000L;

  private long timeOfDayMillis = 1_700_000_000_000L;
  private long monotonicNanos = 5_000_000_000L;

  private SystemClock.TimeBase process(String handed) {
    return SystemClock.TimeBase.of(handed, () -> timeOfDayMillis, () -> monotonicNanos);
  }

  private void pass(long millis) {
    timeOfDayMillis += millis;
    monotonicNanos += millis * 1_000_000L;
  }

  @Test
  void micros_timeOfDaySetWhileItRuns_goesOnAsIfNot() {
    SystemClock.TimeBase process = process("");
    pass(1_000);
    timeOfDayMillis += HOUR_MILLIS;

    assertThat(process.micros(monotonicNanos)).isEqualTo(1_700_000_001_000_000L);
  }

  @Test
  void of_processStartedAfterTheTimeOfDayWasSet_agreesWithTheOneThatStartedIt() {
    SystemClock.TimeBase supervisor = process("");
    pass(1_000);
    timeOfDayMillis += HOUR_MILLIS;
    String handed = supervisor.text(monotonicNanos);
    pass(300); // it takes its time to start

    SystemClock.TimeBase child = process(handed);

    assertThat(child.micros(monotonicNanos)).isEqualTo(supervisor.micros(monotonicNanos));
    assertThat(process("").micros(monotonicNanos)).isEqualTo(1_700_003_601_300_000L);
  }

  @Test
  void of_handedOnBetweenMachinesOrNonsense_takesTheTimeOfDay() {
    SystemClock.TimeBase own = process("");

    assertThat(process("17,6000000000")).isEqualTo(own); // monotonic time is ahead: another machine
    monotonicNanos += 3_600_000_000_000L;
    timeOfDayMillis += HOUR_MILLIS;
    assertThat(process("17,5000000000")).isEqualTo(own); // an hour is no start
    assertThat(process("17")).isEqualTo(own);
    assertThat(process("a,b")).isEqualTo(own);
    assertThat(process("")).isEqualTo(own);
  }
}
