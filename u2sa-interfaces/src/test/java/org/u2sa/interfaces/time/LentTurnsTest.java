package org.u2sa.interfaces.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.UndeclaredThrowableException;
import java.net.URL;
import java.net.URLClassLoader;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Turns that threads lend a {@link LockstepClock}: which thread takes them, and how they end. */
@Timeout(120)
class LentTurnsTest {
  private final LockstepClock clock = new LockstepClock();
  private final List<Lender> lenders = new ArrayList<>();
  private final List<String> events = Collections.synchronizedList(new ArrayList<>());

  /** A thread that lends its turns, and keeps what came out of that. */
  private final class Lender extends Thread {
    private final Clock.Waiter waiter;
    private final AtomicReference<Clock.Turns> turns;
    private final List<Thread> takers = Collections.synchronizedList(new ArrayList<>());
    private final List<Thread> running = Collections.synchronizedList(new ArrayList<>());
    private volatile Throwable thrown;
    private volatile boolean ended;
    private volatile boolean flagAtEnd;

    Lender(String name, Clock.Turns turns) {
      super(name);
      this.turns = new AtomicReference<>(turns);
      waiter = clock.newWaiter(name);
      lenders.add(this);
      setDaemon(true);
    }

    @Override
    public void run() {
      try (waiter) {
        waiter.await(0);
        waiter.lend(this::turn);
      } catch (InterruptedException | RuntimeException | Error e) {
        thrown = e;
      } finally {
        flagAtEnd = Thread.interrupted();
        ended = true;
      }
    }

    private long turn() throws InterruptedException {
      takers.add(Thread.currentThread());
      running.add(Clock.runningThread());
      return turns.get().take();
    }
  }

  private Lender lender(String name, Clock.Turns turns) {
    Lender lender = new Lender(name, turns);
    lender.start();
    return lender;
  }

  /** Records its turns, one per period [µs]. */
  private Lender periodic(String name, long periodMicros) {
    return lender(
        name,
        () -> {
          events.add(name + "@" + clock.micros());
          return clock.micros() + periodMicros;
        });
  }

  /** Takes a first turn at 0 µs, and the given ones from 10 µs on. */
  private Lender lenderFrom10(String name, Clock.Turns later) {
    return lender(name, () -> clock.micros() == 0 ? 10 : later.take());
  }

  /** Waiter of the thread whose turn it is. */
  private static Clock.Waiter waiter() {
    return ((Lender) Clock.runningThread()).waiter;
  }

  private interface Body {
    void run(Clock.Waiter waiter) throws InterruptedException;
  }

  /** Starts another thread that waits on the clock. */
  private Thread start(String name, Body body) {
    Clock.Waiter waiter = clock.newWaiter(name);
    return started(
        () -> {
          try (waiter) {
            waiter.await(0);
            body.run(waiter);
          }
        });
  }

  /** Advances the clock on another thread. */
  private Thread drive(long micros) {
    return started(() -> clock.advance(micros));
  }

  private Thread started(ThrowingRunnable body) {
    Thread thread =
        new Thread(
            () -> {
              try {
                body.run();
              } catch (InterruptedException e) {
                events.add("unexpected interrupt");
              }
            });
    thread.setDaemon(true);
    thread.start();
    return thread;
  }

  private interface ThrowingRunnable {
    void run() throws InterruptedException;
  }

  private static void awaitWaiting(Thread thread) {
    while (thread.getState() != Thread.State.WAITING) {
      Thread.yield();
    }
  }

  @AfterEach
  void end() throws InterruptedException {
    for (Lender lender : lenders) {
      lender.turns.set(() -> Clock.Turns.OVER);
      lender.waiter.close();
      lender.join();
    }
  }

  @Test
  void lend_twoLenders_oneOtherThreadTakesTheTurnsOfBothInTheirNames() throws InterruptedException {
    Lender a = periodic("a", 20);
    Lender b = periodic("b", 30);

    clock.advance(60);

    assertThat(events).containsExactly("a@0", "b@0", "a@20", "b@30", "a@40", "a@60", "b@60");
    List<Thread> carriers = new ArrayList<>(a.takers.subList(1, a.takers.size()));
    carriers.addAll(b.takers.subList(1, b.takers.size()));
    assertThat(carriers).doesNotContain(a, b).containsOnly(carriers.get(0));
    assertThat(a.running).containsOnly(a);
    assertThat(b.running).containsOnly(b);
  }

  @Test
  void lend_turnStartsAThread_itIsNoDaemon() throws InterruptedException {
    List<Thread> started = Collections.synchronizedList(new ArrayList<>());
    lender(
        "a",
        () -> {
          Thread thread = new Thread(() -> events.add("started"));
          thread.start();
          started.add(thread);
          return clock.micros() + 10;
        });

    clock.advance(10);

    assertThat(started.get(1).isDaemon()).isFalse(); // though the lender, which made it, is one
    for (Thread thread : started) {
      thread.join();
    }
    assertThat(events).containsExactly("started", "started");
  }

  @Test
  void lend_threadsEndOneByOne_theCarrierEndsWithTheLast() throws InterruptedException {
    Lender a = periodic("a", 20);
    Lender b = periodic("b", 30);
    clock.advance(60);
    Thread carrier = a.takers.get(a.takers.size() - 1);
    a.turns.set(() -> Clock.Turns.OVER);
    clock.advance(20);
    a.join();
    b.takers.clear();

    clock.advance(30);
    assertThat(b.takers).containsExactly(carrier);

    b.turns.set(() -> Clock.Turns.OVER);
    b.waiter.close();
    carrier.join(); // without end if it is left behind
  }

  @Test
  void lend_lastTurnIsOver_theCarrierEndsToo() throws InterruptedException {
    Lender a = periodic("a", 20);
    clock.advance(20);
    Thread carrier = a.takers.get(1);

    a.turns.set(() -> Clock.Turns.OVER);
    clock.advance(20);

    a.join();
    carrier.join();
    assertThat(a.thrown).isNull();
    assertThat(Clock.runningThread()).isSameAs(Thread.currentThread());
  }

  @Test
  void lend_over_theLenderGoesOnBeforeAnybodyElseDoes() throws InterruptedException {
    Thread first =
        start(
            "first",
            waiter -> {
              AtomicInteger turn = new AtomicInteger();
              waiter.lend(() -> turn.incrementAndGet() < 3 ? 10 * turn.get() : Clock.Turns.OVER);
              events.add("over@" + clock.micros());
              waiter.await(clock.micros() + 5);
              events.add("later@" + clock.micros());
            });
    periodic("b", 10);

    clock.advance(30);

    first.join();
    assertThat(events).containsExactly("b@0", "b@10", "over@20", "b@20", "later@25", "b@30");
  }

  @Test
  void lend_turnWaitsInside_othersTakeTurnsMeanwhileAndItGoesOnWhereItWas()
      throws InterruptedException {
    Lender a =
        lender(
            "a",
            () -> {
              events.add("a begins@" + clock.micros());
              waiter().await(clock.micros() + 25);
              events.add("a ends@" + clock.micros());
              return clock.micros() + 100;
            });
    Lender b = periodic("b", 10);

    clock.advance(150);

    assertThat(events.subList(0, 7))
        .containsExactly("a begins@0", "b@0", "b@10", "b@20", "a ends@25", "b@30", "b@40");
    assertThat(events).contains("a begins@125", "a ends@150");
    assertThat(b.takers.get(b.takers.size() - 2)).isNotIn(a.takers.get(1), b, a);
  }

  @Test
  void signal_duringItsOwnTurn_theNextTurnComesAtOnce() throws InterruptedException {
    AtomicInteger signals = new AtomicInteger(3);
    lender(
        "a",
        () -> {
          events.add("a@" + clock.micros());
          if (clock.micros() > 0 && signals.getAndDecrement() > 0) {
            waiter().signal();
          }
          return clock.micros() + 10;
        });
    periodic("b", 10);

    clock.advance(10);

    assertThat(events).containsExactly("a@0", "b@0", "a@10", "a@10", "a@10", "a@10", "b@10");
  }

  @Test
  void signal_fromATurn_comesBeforeDeadlines() throws InterruptedException {
    Lender listener =
        lender(
            "listener",
            () -> {
              events.add("listener@" + clock.micros());
              return Clock.NEVER;
            });
    lender(
        "speaker",
        () -> {
          events.add("speaker@" + clock.micros());
          listener.waiter.signal();
          return clock.micros() + 10;
        });
    periodic("b", 10);

    clock.advance(10);

    assertThat(events)
        .containsExactly(
            "listener@0", "speaker@0", "listener@0", "b@0", "speaker@10", "listener@10", "b@10");
  }

  static List<Throwable> failures() {
    return List.of(
        new IllegalStateException("turn"), new AssertionError("turn"), new IOException("turn"));
  }

  @ParameterizedTest
  @MethodSource("failures")
  void lend_turnThrows_isThrownInTheLenderAndOthersGoOn(Throwable failure)
      throws InterruptedException {
    Lender a =
        lenderFrom10(
            "a",
            () -> {
              LentTurnsTest.<RuntimeException>throwUndeclared(failure);
              return 0;
            });
    periodic("b", 10);

    clock.advance(20);

    a.join();
    if (failure instanceof IOException) { // which take() does not declare
      assertThat(a.thrown).isInstanceOf(UndeclaredThrowableException.class).hasCause(failure);
    } else {
      assertThat(a.thrown).isSameAs(failure);
    }
    assertThat(events).containsExactly("b@0", "b@10", "b@20");
  }

  @SuppressWarnings("unchecked") // so that the compiler lets it pass, as other languages do
  private static <T extends Throwable> void throwUndeclared(Throwable what) throws T {
    throw (T) what;
  }

  @Test
  void interrupt_whileItWaits_endsTheLoanAndOthersGoOn() throws InterruptedException {
    Lender a = periodic("a", 10);
    periodic("b", 10);
    clock.advance(10);
    events.clear();

    a.interrupt();
    a.join();
    clock.advance(10);

    assertThat(a.thrown).isInstanceOf(InterruptedException.class);
    assertThat(a.flagAtEnd).isFalse();
    assertThat(events).containsExactly("b@20");
  }

  @Test
  void interrupt_whileItWaits_theLenderTakesItsOwnTurnsAgain() throws InterruptedException {
    Thread lender =
        start(
            "interrupted",
            waiter -> {
              try {
                waiter.lend(() -> Clock.NEVER);
              } catch (InterruptedException e) {
                events.add("interrupted");
              }
              waiter.await(clock.micros() + 15);
              events.add("later@" + clock.micros());
            });
    periodic("b", 10);
    clock.advance(10);

    lender.interrupt();
    while (!events.contains("interrupted")) {
      Thread.yield();
    }
    clock.advance(20);

    assertThat(events).containsExactly("b@0", "b@10", "interrupted", "b@20", "later@25", "b@30");
  }

  @Test
  void interrupt_whileATurnBlocks_reachesThatTurn() throws InterruptedException {
    CountDownLatch blocks = new CountDownLatch(1);
    AtomicReference<Thread> carrier = new AtomicReference<>();
    Lender a =
        lenderFrom10(
            "a",
            () -> {
              carrier.set(Thread.currentThread());
              blocks.countDown();
              new CountDownLatch(1).await();
              return 0;
            });
    periodic("b", 10);
    Thread driver = drive(20);
    blocks.await();

    a.interrupt();

    a.join();
    driver.join();
    assertThat(carrier.get()).isNotSameAs(a);
    assertThat(a.thrown).isInstanceOf(InterruptedException.class);
    assertThat(a.flagAtEnd).isFalse();
    assertThat(events).containsExactly("b@0", "b@10", "b@20");
  }

  @Test
  void interrupt_turnSetsItsThreadsFlag_endsTheLoanAndNotThatOfAnother()
      throws InterruptedException {
    Lender a =
        lenderFrom10(
            "a",
            () -> {
              Thread.currentThread().interrupt(); // as code does that caught an interrupt
              return 10;
            });
    Lender b = periodic("b", 10);

    clock.advance(20);

    a.join();
    assertThat(a.thrown).isInstanceOf(InterruptedException.class);
    assertThat(b.ended).isFalse();
    assertThat(events).containsExactly("b@0", "b@10", "b@20");
  }

  @Test
  void interrupt_inTheLastTurn_staysTheLendersFlag() throws InterruptedException {
    Lender a =
        lenderFrom10(
            "a",
            () -> {
              Thread.currentThread().interrupt();
              return Clock.Turns.OVER;
            });

    clock.advance(20);

    a.join();
    assertThat(a.thrown).isNull();
    assertThat(a.flagAtEnd).isTrue();
  }

  @Test
  void close_whileItWaits_theLenderTakesItsTurnsItselfUntilTheyAreOver()
      throws InterruptedException {
    Lender a = periodic("a", 10);
    periodic("b", 10);
    clock.advance(10);
    a.takers.clear();
    a.turns.set(() -> Clock.Turns.OVER);

    a.waiter.close();

    a.join();
    assertThat(a.takers).containsExactly(a);
    clock.advance(10);
    assertThat(events).endsWith("b@10", "b@20");
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void close_whileATurnHangs_othersGoOnAndTheLenderWaitsForIt(boolean waitsInside)
      throws InterruptedException {
    CountDownLatch hangs = new CountDownLatch(1);
    CountDownLatch ends = new CountDownLatch(1);
    Lender a =
        lenderFrom10(
            "a",
            () -> {
              hangs.countDown();
              ends.await();
              if (waitsInside) {
                waiter().await(Clock.NEVER); // it is closed: no wait
              }
              ((Lender) Clock.runningThread()).turns.set(() -> Clock.Turns.OVER);
              return clock.micros() + 10;
            });
    periodic("b", 10);
    Thread driver = drive(30);
    hangs.await();

    a.waiter.close();
    driver.join();

    assertThat(events).containsExactly("b@0", "b@10", "b@20", "b@30");
    awaitWaiting(a);
    assertThat(a.ended).isFalse();
    ends.countDown();
    a.join();
    assertThat(a.thrown).isNull();
    assertThat(a.takers).endsWith(a);
  }

  @Test
  void close_ofTheLastLenderWhileATurnHangs_theCarrierEndsWhenTheTurnDoes()
      throws InterruptedException {
    CountDownLatch hangs = new CountDownLatch(1);
    CountDownLatch ends = new CountDownLatch(1);
    Lender a =
        lenderFrom10(
            "a",
            () -> {
              hangs.countDown();
              ends.await();
              return Clock.Turns.OVER;
            });
    Thread driver = drive(30);
    hangs.await();
    Thread carrier = a.takers.get(1);

    a.waiter.close();
    driver.join();
    ends.countDown();

    carrier.join();
    a.join();
    assertThat(clock.micros()).isEqualTo(30);
  }

  @Test
  void lend_lenderHasItsOwnClassLoader_turnsSeeIt() throws Exception {
    try (URLClassLoader loader = new URLClassLoader(new URL[0])) {
      List<ClassLoader> seen = Collections.synchronizedList(new ArrayList<>());
      Lender a =
          new Lender(
              "a",
              () -> {
                seen.add(Thread.currentThread().getContextClassLoader());
                return clock.micros() + 10;
              });
      a.setContextClassLoader(loader);
      a.start();
      Lender b = periodic("b", 10);

      clock.advance(30);

      assertThat(seen).hasSizeGreaterThan(2).containsOnly(loader);
      assertThat(b.takers.get(2).getContextClassLoader())
          .isSameAs(Thread.currentThread().getContextClassLoader());
    }
  }

  @Test
  void lend_againAfterTheTurnsWereOver_isCarriedAgain() throws InterruptedException {
    List<Thread> takers = Collections.synchronizedList(new ArrayList<>());
    Thread again =
        start(
            "again",
            waiter -> {
              for (int i = 0; i < 2; i++) {
                AtomicInteger left = new AtomicInteger(3);
                waiter.lend(
                    () -> {
                      takers.add(Thread.currentThread());
                      return left.decrementAndGet() > 0 ? clock.micros() + 10 : Clock.Turns.OVER;
                    });
              }
            });
    periodic("b", 10);

    clock.advance(100);

    again.join();
    assertThat(takers).hasSize(6);
    assertThat(takers.get(0)).isSameAs(again);
    assertThat(takers.get(3)).isSameAs(again);
    assertThat(List.of(takers.get(1), takers.get(4))).doesNotContain(again);
    assertThat(events).hasSize(11);
    for (Lender lender : lenders) {
      lender.turns.set(() -> Clock.Turns.OVER);
      lender.waiter.close();
    }
    takers.get(4).join(); // without end if it is left behind
  }
}
