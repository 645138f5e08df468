package org.u2sa.interfaces.time;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * Simulated time in lockstep: one thread runs at a time, and time moves only when all of them wait.
 *
 * <p>Threads take turns in an order that depends on nothing but their own signals and deadlines:
 * whoever was signalled first runs first, then whoever's deadline is nearest (of equal ones, whose
 * waiter was made first). So a run with many threads repeats bit for bit, as fast as the machine
 * allows, and every service has answered a step of the simulation before the next one begins.
 *
 * <p>Waking a sleeping thread takes the machine longer than most turns last. So whoever is certain
 * to be next is woken while the one before still runs, and looks out for its turn for a few
 * microseconds before it sleeps again. That changes when a thread wakes, never whose turn it is.
 *
 * <p>The thread that calls {@link #runUntil} or {@link #advance} drives: it is blocked while the
 * services run. A waiter counts as busy from its creation until its thread first waits, so make it
 * where the order is certain (in the thread that starts the services) and start its thread.
 */
public final class LockstepClock implements Clock {
  /** With one core, who looks out for its turn would only keep the core from whoever has it. */
  private static final boolean CALLS_AHEAD = Runtime.getRuntime().availableProcessors() > 1;

  private final Object lock =
      new Object(); // guards everything below but nowMicros, which it guards for writing
  private final List<Turn> turns = new ArrayList<>(); // in order of creation
  private final ArrayDeque<Turn> ready =
      new ArrayDeque<>(); // signalled while waiting, first come first
  private int busy; // turns that are not waiting
  private volatile long nowMicros;
  private long targetMicros;
  private BooleanSupplier done;
  private Throwable failure; // of the condition; thrown where it came from, in the driver
  private boolean driving;

  @Override
  public long micros() {
    return nowMicros;
  }

  @Override
  public Waiter newWaiter(String name) {
    synchronized (lock) {
      Turn turn = new Turn();
      turns.add(turn);
      busy++;
      return turn;
    }
  }

  /**
   * Lets everything happen that is due in the next span of time, its end included, and returns when
   * all threads wait.
   *
   * @param micros span [µs], not negative; 0 lets threads answer what they have been sent
   * @throws InterruptedException if the calling thread was interrupted
   */
  public void advance(long micros) throws InterruptedException {
    if (micros < 0) {
      throw new IllegalArgumentException(
          "micros: " + micros + " is negative; time does not run backwards");
    }
    drive(() -> false, nowMicros + micros);
  }

  /**
   * Lets time run until the condition holds or the limit is reached.
   *
   * @param condition asked whenever time is about to move, while no service runs; must not block
   * @param limitMicros time of this clock [µs] at which to give up
   * @return whether the condition held
   * @throws InterruptedException if the calling thread was interrupted
   * @throws RuntimeException what the condition threw, if it did
   */
  public boolean runUntil(BooleanSupplier condition, long limitMicros) throws InterruptedException {
    drive(condition, limitMicros);
    return condition.getAsBoolean();
  }

  private void drive(BooleanSupplier condition, long limitMicros) throws InterruptedException {
    synchronized (lock) {
      if (driving) {
        throw new IllegalStateException("another thread already drives this clock");
      }
      driving = true;
      done = condition;
      targetMicros = limitMicros;
      try {
        passTurnIfIdle();
        while (driving) {
          lock.wait();
        }
        throwFailure();
      } finally {
        driving = false;
        failure = null;
      }
    }
  }

  private void throwFailure() {
    if (failure instanceof Error error) {
      throw error;
    }
    if (failure instanceof RuntimeException exception) {
      throw exception;
    }
  }

  /**
   * Whether the driver's condition holds. It is asked on whichever thread waits last, but what it
   * throws belongs to the driver: that thread's service must neither die of it nor leave the driver
   * waiting.
   */
  private boolean isDone() {
    try {
      return done.getAsBoolean();
    } catch (RuntimeException | Error e) {
      failure = e;
      return true;
    }
  }

  /** Gives the turn to whoever is next, or back to the driver. The caller holds the lock. */
  private void passTurnIfIdle() {
    if (!driving || busy > 0) {
      return;
    }
    Turn next = ready.poll();
    if (next == null && !isDone()) {
      next = earliest();
      if (next != null && next.deadlineMicros <= targetMicros) {
        nowMicros = Math.max(nowMicros, next.deadlineMicros);
      } else {
        next = null;
        nowMicros = Math.max(nowMicros, targetMicros == NEVER ? nowMicros : targetMicros);
      }
    }
    if (next == null) {
      driving = false;
      lock.notifyAll();
    } else {
      next.take();
      callAhead();
    }
  }

  /** Wakes the thread whose turn is certain to come next. The caller holds the lock. */
  private void callAhead() {
    Turn next = ready.peek();
    if (CALLS_AHEAD && next != null) {
      next.wait.callAhead();
    }
  }

  private Turn earliest() {
    Turn earliest = null;
    for (Turn turn : turns) {
      if (turn.deadlineMicros != NEVER
          && (earliest == null || turn.deadlineMicros < earliest.deadlineMicros)) {
        earliest = turn;
      }
    }
    return earliest;
  }

  /** One thread's place in the order. Its fields are guarded by the clock's lock. */
  private final class Turn implements Waiter {
    private Thread thread; // known once it has waited
    private final TurnWait wait = new TurnWait();
    private boolean queued;
    private boolean signalled;
    private boolean closed;
    private long deadlineMicros = NEVER;

    @Override
    public void await(long deadline) throws InterruptedException {
      synchronized (lock) {
        if (closed) {
          return;
        }
        // A thread's first wait is where it joins the order, so it gives its turn up whatever is
        // pending.
        if (signalled && thread != null) {
          signalled = false;
          return;
        }
        thread = Thread.currentThread();
        deadlineMicros = deadline;
        wait.begin();
        busy--;
        if (signalled) {
          signal();
        }
        passTurnIfIdle();
      }
      while (wait.isWaiting()) {
        wait.await();
        if (Thread.interrupted()) {
          synchronized (lock) {
            if (wait.isWaiting()) {
              take();
            }
          }
          throw new InterruptedException();
        }
      }
    }

    private void take() {
      ready.remove(this);
      queued = false;
      signalled = false;
      deadlineMicros = NEVER;
      busy++;
      wait.end();
    }

    @Override
    public void signal() {
      synchronized (lock) {
        signalled = true;
        if (wait.isWaiting() && !queued) {
          queued = true;
          ready.add(this);
          if (ready.size() == 1) {
            callAhead(); // those behind it are, once it has its turn
          }
        }
      }
    }

    @Override
    public void close() {
      synchronized (lock) {
        if (closed) {
          return;
        }
        closed = true;
        if (wait.isWaiting()) {
          take(); // its thread returns from await and ends; it is no longer waited for
        }
        turns.remove(this);
        busy--;
        passTurnIfIdle();
      }
    }
  }
}
