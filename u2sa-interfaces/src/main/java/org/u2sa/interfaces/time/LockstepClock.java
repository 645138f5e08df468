package org.u2sa.interfaces.time;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;

/**
 * Simulated time in lockstep: one thread runs at a time, and time moves only when all of them wait.
 *
 * <p>Threads take turns in an order that depends on nothing but their own signals and deadlines:
 * whoever was signalled first runs first, then whoever's deadline is nearest (of equal ones, whose
 * waiter was made first). So a run with many threads repeats bit for bit, as fast as the machine
 * allows, and every service has answered a step of the simulation before the next one begins.
 *
 * <p>The thread that calls {@link #runUntil} or {@link #advance} drives: it is blocked while the
 * services run. A waiter counts as busy from its creation until its thread first waits, so make it
 * where the order is certain (in the thread that starts the services) and start its thread.
 */
public final class LockstepClock implements Clock {
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
    private volatile boolean waiting; // read by its own thread without the lock
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
        waiting = true;
        busy--;
        if (signalled) {
          signal();
        }
        passTurnIfIdle();
      }
      while (waiting) {
        LockSupport.park(this);
        if (Thread.interrupted()) {
          synchronized (lock) {
            if (waiting) {
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
      waiting = false;
      LockSupport.unpark(thread);
    }

    @Override
    public void signal() {
      synchronized (lock) {
        signalled = true;
        if (waiting && !queued) {
          queued = true;
          ready.add(this);
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
        if (waiting) {
          take(); // its thread returns from await and ends; it is no longer waited for
        }
        turns.remove(this);
        busy--;
        passTurnIfIdle();
      }
    }
  }
}
