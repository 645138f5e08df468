package org.u2sa.interfaces.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Threads that signal each other at random take their turns in the order that {@link LockstepClock}
 * promises, however fast each of them wakes, and whether they lend their turns or take them.
 */
@Timeout(120)
class LockstepOrderTest {
  private final List<String> turns = Collections.synchronizedList(new ArrayList<>());
  private final List<Clock.Waiter> waiters = new ArrayList<>();
  private final List<Thread> threads = new ArrayList<>();

  /** What one thread does in its turns, the same at each run. */
  private static final class Script {
    private final Random random;
    private final int self;
    private final int threads;

    Script(long seed, int self, int threads) {
      random = new Random(seed * 31 + self);
      this.self = self;
      this.threads = threads;
    }

    /** Whom it signals in this turn, itself perhaps. */
    List<Integer> signalled() {
      List<Integer> whom = new ArrayList<>();
      if (random.nextInt(3) > 0) {
        whom.add(random.nextInt(threads));
      }
      if (random.nextInt(4) == 0) {
        whom.add((self + 1) % threads);
      }
      return whom;
    }

    /** Until when it waits then; the first one never waits for signals alone, so all go on. */
    long deadline(long nowMicros) {
      return random.nextInt(4) == 0 && self > 0 ? Clock.NEVER : nowMicros + 1 + random.nextInt(50);
    }

    /** How much it computes in this turn: less and more than a waking takes. */
    int work() {
      return random.nextInt(20) == 0 ? 20_000 : random.nextInt(200);
    }
  }

  /** The order as documented, worked out by one thread. */
  private static List<String> promised(long seed, int threads, int most) {
    List<String> order = new ArrayList<>();
    Script[] scripts = new Script[threads];
    long[] deadlines = new long[threads];
    boolean[] again = new boolean[threads];
    List<Integer> ready = new ArrayList<>();
    for (int i = 0; i < threads; i++) {
      scripts[i] = new Script(seed, i, threads);
    }
    long now = 0;
    while (order.size() < most) {
      int next;
      if (!ready.isEmpty()) {
        next = ready.remove(0);
      } else {
        next = 0;
        for (int i = 1; i < threads; i++) {
          next = deadlines[i] < deadlines[next] ? i : next;
        }
        now = Math.max(now, deadlines[next]);
      }
      do {
        again[next] = false;
        order.add(next + "@" + now);
        scripts[next].work();
        for (int other : scripts[next].signalled()) {
          if (other == next) {
            again[next] = true; // its next wait ends at once
          } else if (!ready.contains(other)) {
            ready.add(other);
          }
        }
        deadlines[next] = scripts[next].deadline(now);
      } while (again[next]);
    }
    return order;
  }

  private void start(LockstepClock clock, long seed, int count, int takers) {
    for (int i = 0; i < count; i++) {
      waiters.add(clock.newWaiter("w" + i));
    }
    for (int i = 0; i < count; i++) {
      int self = i;
      boolean lends = i >= takers;
      Thread thread = new Thread(() -> live(clock, new Script(seed, self, count), self, lends));
      thread.setDaemon(true);
      threads.add(thread);
      thread.start();
    }
  }

  private void live(LockstepClock clock, Script script, int self, boolean lends) {
    try {
      Clock.Waiter waiter = waiters.get(self);
      waiter.await(0);
      Clock.Turns turn = () -> turn(clock, script, self);
      if (lends) {
        waiter.lend(turn);
      }
      while (true) {
        waiter.await(turn.take());
      }
    } catch (InterruptedException e) {
      waiters.get(self).close();
    }
  }

  private long turn(LockstepClock clock, Script script, int self) {
    turns.add(self + "@" + clock.micros());
    double work = 0.0;
    for (int i = script.work(); i > 0; i--) {
      work = Math.sqrt(work + i);
    }
    assertThat(work).isNotNegative(); // so that it is computed
    script.signalled().forEach(other -> waiters.get(other).signal());
    return script.deadline(clock.micros());
  }

  @AfterEach
  void end() throws InterruptedException {
    threads.forEach(Thread::interrupt);
    for (Thread thread : threads) {
      thread.join();
    }
  }

  @ParameterizedTest
  @CsvSource({"1, 2, 2", "2, 3, 0", "3, 5, 5", "3, 5, 0", "3, 5, 2", "4, 9, 9", "4, 9, 1"})
  void runUntil_randomSignals_turnsComeInThePromisedOrder(long seed, int count, int takers)
      throws InterruptedException {
    LockstepClock clock = new LockstepClock();
    start(clock, seed, count, takers);

    clock.runUntil(() -> turns.size() >= 1_500, 1_000_000);

    List<String> came = List.copyOf(turns);
    assertThat(came)
        .hasSizeGreaterThanOrEqualTo(1_500)
        .isEqualTo(promised(seed, count, came.size()));
  }
}
