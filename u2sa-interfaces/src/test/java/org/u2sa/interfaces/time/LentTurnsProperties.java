package org.u2sa.interfaces.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/**
 * Threads that signal and close each other, wait inside of their turns, fail and end at random do
 * all that in the same order, whether each takes its turns itself or lends them.
 */
class LentTurnsProperties {
  private static final int TURNS = 150;

  /** One run of all threads. */
  private static final class Scenario {
    private final LockstepClock clock = new LockstepClock();
    private final List<String> events = Collections.synchronizedList(new ArrayList<>());
    private final List<Member> members = new ArrayList<>();

    /**
     * @param lends by bit, who of them does
     */
    Scenario(long seed, int count, int lends) {
      for (int i = 0; i < count; i++) {
        members.add(new Member(i, new Random(seed * 31 + i), (lends >> i & 1) == 1));
      }
    }

    List<String> run() throws InterruptedException {
      members.forEach(Thread::start);
      clock.runUntil(() -> events.size() >= TURNS, 100_000);
      List<String> came = List.copyOf(events);
      for (Member member : members) {
        member.endsNow();
      }
      for (Member member : members) {
        member.join();
      }
      for (Member member : members) {
        if (member.carrier != null) {
          member.carrier.join(); // without end if one is left behind
        }
      }
      return came;
    }

    private final class Member extends Thread {
      private final int self;
      private final Random random;
      private final boolean lends;
      private final Clock.Waiter waiter;
      private volatile boolean ends;
      private volatile Thread carrier;

      Member(int self, Random random, boolean lends) {
        this.self = self;
        this.random = random;
        this.lends = lends;
        waiter = clock.newWaiter("m" + self);
        setDaemon(true);
      }

      void endsNow() {
        ends = true;
        waiter.close();
      }

      @Override
      public void run() {
        try (waiter) {
          note(live());
        }
      }

      /** Returns how it ended, while nobody else has the turn. */
      private String live() {
        try {
          waiter.await(0);
          if (lends) {
            waiter.lend(this::turn);
          } else {
            for (long next = turn(); next != Clock.Turns.OVER; next = turn()) {
              waiter.await(next);
            }
          }
          return "over";
        } catch (InterruptedException e) {
          return "interrupted";
        } catch (IllegalStateException e) {
          return "failed";
        }
      }

      private void note(String what) {
        if (!ends) {
          events.add(self + " " + what + "@" + clock.micros());
        }
      }

      private long turn() throws InterruptedException {
        if (Thread.currentThread() != this) {
          carrier = Thread.currentThread();
        }
        if (Clock.runningThread() != this) {
          note("runs as another");
        }
        note("turn");
        for (int acts = random.nextInt(3); acts > 0 && !ends; acts--) {
          members.get(random.nextInt(members.size())).waiter.signal();
        }
        if (random.nextInt(4) == 0) {
          waiter.await(clock.micros() + random.nextInt(30));
          note("goes on");
        }
        return ends ? Clock.Turns.OVER : end();
      }

      private long end() {
        switch (self == 0 ? 99 : random.nextInt(100)) {
          case 0:
            return Clock.Turns.OVER;
          case 1:
            throw new IllegalStateException("at random");
          case 2:
            members.get(1 + random.nextInt(members.size() - 1)).endsNow();
            return ends ? Clock.Turns.OVER : clock.micros() + 1;
          default:
            return self > 0 && random.nextInt(4) == 0
                ? Clock.NEVER
                : clock.micros() + random.nextInt(50);
        }
      }
    }
  }

  @Property(tries = 40)
  void lend_anyScenario_everythingHappensInTheOrderOfTurnsThatAreNotLent(
      @ForAll long seed, @ForAll @IntRange(min = 2, max = 9) int count, @ForAll int lends)
      throws InterruptedException {
    List<String> own = new Scenario(seed, count, 0).run();

    assertThat(own).isNotEmpty();
    assertThat(new Scenario(seed, count, -1).run()).isEqualTo(own);
    assertThat(new Scenario(seed, count, lends).run()).isEqualTo(own);
  }
}
