package org.u2sa.interfaces.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(120)
class LockstepClockTest {
  private final LockstepClock clock = new LockstepClock();
  private final List<String> events = Collections.synchronizedList(new ArrayList<>());
  private volatile Clock.Waiter closed; // whose thread has to end

  /** A thread that notes its name and the time whenever it has its turn. */
  private Clock.Waiter periodic(String name, long periodMicros) {
    Clock.Waiter waiter = clock.newWaiter(name);
    Thread thread =
        new Thread(
            () -> {
              try {
                waiter.await(0);
                for (long due = 0; ; due += periodMicros) {
                  waiter.await(due);
                  if (waiter == closed) {
                    return; // its waits end at once from now on
                  }
                  events.add(name + "@" + clock.micros());
                }
              } catch (InterruptedException e) {
                events.add(name + " interrupted");
              }
            });
    thread.setDaemon(true);
    thread.start();
    return waiter;
  }

  @Test
  void advance_twoPeriods_wakesInOrderOfTimeAndThenOfCreation() throws InterruptedException {
    periodic("a", 20);
    periodic("b", 30);

    clock.advance(60);

    assertThat(events).containsExactly("a@0", "b@0", "a@20", "b@30", "a@40", "a@60", "b@60");
    assertThat(clock.micros()).isEqualTo(60);
  }

  private interface Body {
    void run() throws InterruptedException;
  }

  private void start(Body forever) {
    Thread thread =
        new Thread(
            () -> {
              try {
                while (true) {
                  forever.run();
                }
              } catch (InterruptedException e) {
                events.add("interrupted");
              }
            });
    thread.setDaemon(true);
    thread.start();
  }

  @Test
  void signal_fromTheThreadThatRuns_wakesBeforeTimeMoves() throws InterruptedException {
    Clock.Waiter follower = clock.newWaiter("follower");
    start(
        () -> {
          follower.await(Clock.NEVER);
          events.add("follower@" + clock.micros());
        });
    Clock.Waiter leader = clock.newWaiter("leader");
    AtomicInteger due = new AtomicInteger();
    start(
        () -> {
          leader.await(due.addAndGet(10));
          events.add("leader@" + clock.micros());
          follower.signal();
        });

    clock.advance(20);

    assertThat(events).containsExactly("leader@10", "follower@10", "leader@20", "follower@20");
  }

  @Test
  void runUntil_conditionHolds_stopsBeforeTimeMovesOn() throws InterruptedException {
    periodic("a", 10);

    boolean held = clock.runUntil(() -> events.size() >= 3, 1_000);

    assertThat(held).isTrue();
    assertThat(clock.micros()).isEqualTo(20);
  }

  @Test
  void runUntil_limitReached_saysSo() throws InterruptedException {
    periodic("a", 10);

    assertThat(clock.runUntil(() -> false, 35)).isFalse();
    assertThat(clock.micros()).isEqualTo(35);
  }

  @Test
  void close_ofOneWaiter_othersGoOn() throws InterruptedException {
    Clock.Waiter ending = periodic("ending", 10);
    periodic("a", 10);
    clock.advance(10);
    events.clear();

    closed = ending;
    ending.close();
    clock.advance(10);

    assertThat(events).contains("a@20");
  }

  @Test
  void advance_manyThreads_oneRunsAtATime() throws InterruptedException {
    AtomicInteger running = new AtomicInteger();
    AtomicInteger mostAtOnce = new AtomicInteger();
    for (int i = 0; i < 8; i++) {
      Clock.Waiter waiter = clock.newWaiter("w" + i);
      AtomicInteger due = new AtomicInteger();
      start(
          () -> {
            waiter.await(due.getAndIncrement());
            mostAtOnce.accumulateAndGet(running.incrementAndGet(), Math::max);
            running.decrementAndGet();
          });
    }

    clock.advance(500);

    assertThat(mostAtOnce).hasValue(1);
  }

  @Test
  void advance_negative_isRefused() {
    assertThatThrownBy(() -> clock.advance(-1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("-1");
  }

  @Test
  void runUntil_conditionThrows_throwsInTheDriverAndTheThreadsGoOn() throws InterruptedException {
    periodic("a", 10);
    IllegalStateException failure = new IllegalStateException("condition");

    assertThatThrownBy(
            () ->
                clock.runUntil(
                    () -> {
                      if (clock.micros() >= 10) {
                        throw failure;
                      }
                      return false;
                    },
                    1_000))
        .isSameAs(failure);

    clock.advance(10);
    assertThat(events).containsExactly("a@0", "a@10", "a@20");
  }

  @Test
  void signal_fromOutsideWhileNobodyDrives_isAnsweredWhenTimeIsDrivenAgain()
      throws InterruptedException {
    Clock.Waiter waiter = periodic("a", 10);
    clock.advance(10);
    events.clear();

    waiter.signal();
    clock.advance(0);

    assertThat(events).containsExactly("a@10");
  }

  @Test
  void await_interrupted_throwsAndTimeGoesOnAfterItsWaiterIsClosed() throws InterruptedException {
    List<Throwable> thrown = Collections.synchronizedList(new ArrayList<>());
    Clock.Waiter waiter = clock.newWaiter("interrupted");
    Thread thread =
        new Thread(
            () -> {
              try (waiter) {
                waiter.await(Clock.NEVER);
              } catch (InterruptedException e) {
                thrown.add(e);
              }
            });
    thread.start();
    clock.advance(5);

    thread.interrupt();
    thread.join();
    clock.advance(5);

    assertThat(thrown).hasSize(1);
    assertThat(clock.micros()).isEqualTo(10);
  }
}
