package org.u2sa.interfaces.time;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(120)
class SystemClockTest {
  /** By so much the time of day may be set right between start and test. */
  private static final long CORRECTED_MS = 2_000;

  private final SystemClock clock = new SystemClock();
  private final Clock.Waiter waiter = clock.newWaiter("test");

  @Test
  void await_deadline_returnsNotBeforeIt() throws InterruptedException {
    long deadline = clock.micros() + 5_000;

    waiter.await(deadline);

    assertThat(clock.micros()).isGreaterThanOrEqualTo(deadline);
  }

  @Test
  void await_signalledBefore_returnsAtOnceAndWaitsTheNextTime() throws InterruptedException {
    waiter.signal();
    waiter.signal();

    waiter.await(Clock.NEVER);
    long deadline = clock.micros() + 2_000;
    waiter.await(deadline);

    assertThat(clock.micros()).isGreaterThanOrEqualTo(deadline);
  }

  @Test
  void signal_fromAnotherThread_endsTheWait() throws InterruptedException {
    Thread other = new Thread(waiter::signal);
    other.start();

    waiter.await(Clock.NEVER);

    other.join();
  }

  @Test
  void close_endsThisAndLaterWaits() throws InterruptedException {
    Thread other = new Thread(waiter::close);
    other.start();

    waiter.await(Clock.NEVER);
    waiter.await(Clock.NEVER);

    other.join();
  }

  @Test
  void await_looksOutBeforeItSleeps_returnsAtTheDeadlineOrTheSignal() throws InterruptedException {
    Clock.Waiter awake = clock.newWaiter("awake", 500);
    long deadline = clock.micros() + 5_000;

    awake.await(deadline);

    assertThat(clock.micros()).isGreaterThanOrEqualTo(deadline);
    Thread other = new Thread(awake::signal);
    other.start();
    awake.await(Clock.NEVER);
    other.join();
    awake.close();
    awake.await(Clock.NEVER);
  }

  @Test
  void ahead_isSoAtOnceAndForGood() {
    SystemClock ahead = clock.ahead(3_600_000_000L);

    long before = clock.micros();
    long between = ahead.micros() - 3_600_000_000L;
    long after = clock.micros();

    assertThat(between).isBetween(before, after);
  }

  @Test
  void micros_isTimeOfDay() {
    long before = System.currentTimeMillis();
    long between = clock.micros() / 1_000;
    long after = System.currentTimeMillis();

    assertThat(between).isBetween(before - CORRECTED_MS, after + CORRECTED_MS);
  }
}
