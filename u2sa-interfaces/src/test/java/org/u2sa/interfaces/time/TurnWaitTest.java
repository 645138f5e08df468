package org.u2sa.interfaces.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(120)
class TurnWaitTest {
  private final TurnWait wait = new TurnWait();

  private Thread waiting() {
    wait.begin();
    Thread thread = new Thread(wait::await);
    thread.setDaemon(true);
    thread.start();
    return thread;
  }

  private static void awaitAsleep(Thread thread) {
    while (thread.getState() != Thread.State.WAITING) {
      Thread.yield();
    }
  }

  @Test
  void await_endedBefore_returnsAtOnce() {
    wait.begin();
    wait.end();

    wait.await();

    assertThat(wait.isWaiting()).isFalse();
  }

  @Test
  void await_calledAheadForNothing_sleepsAgainUntilTheEnd() throws InterruptedException {
    Thread thread = waiting();
    awaitAsleep(thread);

    wait.callAhead();
    wait.callAhead();
    awaitAsleep(thread); // does not look out for long
    assertThat(wait.isWaiting()).isTrue();

    wait.end();
    thread.join();
  }

  @Test
  void await_interruptedWhileAsleep_returnsStillWaiting() throws InterruptedException {
    Thread thread = waiting();
    awaitAsleep(thread);

    thread.interrupt();
    thread.join();

    assertThat(wait.isWaiting()).isTrue();
  }

  @Test
  void begin_calledAheadBefore_beginsWithoutTheCall() throws InterruptedException {
    wait.begin();
    wait.callAhead();
    wait.end();
    wait.await();

    Thread thread = waiting();
    awaitAsleep(thread);
    wait.end();
    thread.join();
  }

  /** Wakes at every moment of the other's falling asleep; a wake that is lost hangs. */
  @Test
  void end_atAnyMoment_neverLost() throws InterruptedException {
    int rounds = 3_000;
    AtomicLong ended = new AtomicLong();
    Thread thread =
        new Thread(
            () -> {
              for (int i = 0; i < rounds; i++) {
                wait.await();
                wait.begin();
                ended.incrementAndGet();
              }
            });
    thread.setDaemon(true);
    wait.begin();
    thread.start();
    Random random = new Random(1);
    for (int i = 0; i < rounds; i++) {
      while (ended.get() < i) {
        Thread.yield();
      }
      if (random.nextBoolean()) {
        wait.callAhead();
      }
      for (int spins = random.nextInt(200); spins > 0; spins--) {
        Thread.onSpinWait();
      }
      wait.end();
    }
    thread.join();

    assertThat(ended).hasValue(rounds);
  }
}
