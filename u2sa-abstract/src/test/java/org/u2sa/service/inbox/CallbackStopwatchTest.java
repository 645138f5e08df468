package org.u2sa.service.inbox;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.time.Clock;

class CallbackStopwatchTest {
  private final Ticking real = new Ticking();
  private final Ticking simulated = new Ticking();

  /** Is a microsecond later each time that somebody looks. */
  private static final class Ticking implements Clock {
    private long micros;

    @Override
    public long micros() {
      return ++micros;
    }

    @Override
    public Waiter newWaiter(String name) {
      throw new UnsupportedOperationException();
    }
  }

  @Test
  void realTime_oneCallbackAfterTheOther_oneLookEach() {
    CallbackStopwatch stopwatch = new CallbackStopwatch(real, real);
    assertThat(stopwatch.runMicros()).isEqualTo(1);
    for (int end = 2; end < 5; end++) {
      assertThat(stopwatch.begin()).isEqualTo(end - 1);
      assertThat(stopwatch.end()).isEqualTo(end);
      assertThat(stopwatch.runMicros()).isEqualTo(end);
    }
  }

  @Test
  void realTime_pauseOrCallbackWithoutEnd_looksAgain() {
    CallbackStopwatch stopwatch = new CallbackStopwatch(real, real);
    stopwatch.begin();
    assertThat(stopwatch.runMicros()).isEqualTo(2);
    stopwatch.pause();
    assertThat(stopwatch.runMicros()).isEqualTo(3);
    assertThat(stopwatch.realMicrosElsewhere()).isEqualTo(4);
    assertThat(stopwatch.realMicros()).isEqualTo(3);
  }

  @Test
  void simulation_realTimeOfCallbacks_isNotThatOfTheRun() {
    CallbackStopwatch stopwatch = new CallbackStopwatch(simulated, real);
    simulated.micros = 1_000;

    assertThat(stopwatch.begin()).isEqualTo(1);
    assertThat(stopwatch.end()).isEqualTo(2);
    assertThat(stopwatch.runMicros()).isEqualTo(1_001);
    assertThat(stopwatch.runMicros()).isEqualTo(1_002);
    assertThat(stopwatch.begin()).isEqualTo(2);
  }
}
