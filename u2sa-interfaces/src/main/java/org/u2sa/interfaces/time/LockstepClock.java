package org.u2sa.interfaces.time;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * Simulated time in lockstep: one thread runs at a time, and time advances only when all of them
 * wait.
 *
 * <p>The order of turns depends only on the threads' signals and deadlines: signalled threads run
 * first, in order of their signals, then the earliest deadline (ties: the waiter created first). A
 * multi-threaded run is therefore bit-for-bit repeatable, runs as fast as the machine allows, and
 * every service has reacted to a simulation step before the next one begins.
 *
 * <p>Waking a sleeping thread takes longer than most turns. Therefore {@linkplain Waiter#lend lent}
 * turns run one after the other on one thread of the clock, a carrier. A thread that keeps its
 * turns and is certain to be next is woken while the previous turn still runs, and spins for a few
 * microseconds before it sleeps again. Both affect which thread runs and when it wakes, never the
 * order of turns.
 *
 * <p>The thread that calls {@link #runUntil} or {@link #advance} is the driver: it is blocked while
 * the services run. A waiter counts as busy from its creation until its thread first waits, so
 * create it where the order is deterministic (in the thread that starts the services) and start its
 * thread. Time advances without a thread that has the turn but blocks on something else, if its
 * waiter was created by {@link #newWaiter(Thread, Runnable)}.
 */
public final class LockstepClock implements Clock {
  /** On a single core a spinning thread would only take the core from the running one. */
  private static final boolean CALLS_AHEAD = Runtime.getRuntime().availableProcessors() > 1;

  private static final long LOOKS_EVERY_MS = 10;

  private final Object lock = new Object(); // guards all fields below; nowMicros only for writing
  private final List<Turn> turns = new ArrayList<>(); // in order of creation
  private final ArrayDeque<Turn> ready = new ArrayDeque<>(); // signalled while waiting, FIFO
  private final LentTurnThreads carriers = new LentTurnThreads();
  private final List<Turn> unreliable = new ArrayList<>(); // threads that may block elsewhere
  private int busy; // turns that are not waiting
  private volatile long nowMicros;
  private long targetMicros;
  private BooleanSupplier done;
  private Throwable failure; // thrown by the condition; rethrown in the driver
  private boolean driving;

  @Override
  public boolean isSimulated() {
    return true;
  }

  @Override
  public long micros() {
    return nowMicros;
  }

  @Override
  public Waiter newWaiter(String name) {
    synchronized (lock) {
      return newTurn(null);
    }
  }

  @Override
  public Waiter newWaiter(Thread thread, Runnable outOfStep) {
    synchronized (lock) {
      Turn turn = newTurn(new StepWatch(thread, outOfStep));
      unreliable.add(turn);
      lock.notifyAll(); // starts the driver's watch
      return turn;
    }
  }

  private Turn newTurn(StepWatch watch) {
    Turn turn = new Turn(watch);
    turns.add(turn);
    busy++;
    return turn;
  }

  /**
   * Advances time by a span [µs], running everything due up to and including its end; returns when
   * all threads wait. A span of 0 only lets threads handle pending signals.
   */
  public void advance(long micros) throws InterruptedException {
    if (micros < 0) {
      throw new IllegalArgumentException(
          "micros: " + micros + " is negative; time does not run backwards");
    }
    drive(() -> false, nowMicros + micros);
  }

  /**
   * Advances time until the condition holds or the limit is reached.
   *
   * @param condition evaluated before each advance, while no service runs; must not block
   * @param limitMicros time of this clock [µs]
   * @return whether the condition held
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
        awaitEndOfDrive();
        throwFailure();
      } finally {
        driving = false;
        failure = null;
      }
    }
  }

  private void awaitEndOfDrive() throws InterruptedException {
    while (driving) {
      if (unreliable.isEmpty()) {
        lock.wait();
      } else {
        lock.wait(LOOKS_EVERY_MS);
        List.copyOf(unreliable).forEach(Turn::leaveIfElsewhere);
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
   * Evaluates the driver's condition on the last thread to wait. Exceptions go to the driver: they
   * must neither kill that thread's service nor leave the driver blocked.
   */
  private boolean isDone() {
    try {
      return done.getAsBoolean();
    } catch (RuntimeException | Error e) {
      failure = e;
      return true;
    }
  }

  /** Passes the turn to the next thread, or back to the driver. The caller holds the lock. */
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
      next.grant();
      callAhead();
    }
  }

  /** Wakes the thread whose turn is certain to come next. The caller holds the lock. */
  private void callAhead() {
    Turn next = ready.peek();
    if (CALLS_AHEAD && next != null && !next.isLent) {
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

  /** One thread's position in the order. Guarded by the clock's lock. */
  private final class Turn implements Waiter {
    private final StepWatch watch; // null if time always waits for the thread
    private boolean hasLeft; // time advances without the thread
    private boolean hasWaited;
    private final TurnWait wait = new TurnWait();
    private LentTurns loan; // the last one; null if it never lent
    private boolean isLent; // while waiting for a turn that a carrier will run
    private boolean queued;
    private boolean signalled;
    private boolean closed;
    private long deadlineMicros = NEVER;

    Turn(StepWatch watch) {
      this.watch = watch;
    }

    private void leaveIfElsewhere() {
      if (!wait.isWaiting() && !hasLeft && watch.isElsewhere()) {
        hasLeft = true;
        busy--;
        passTurnIfIdle();
      }
    }

    private void rejoin() {
      if (watch != null) {
        watch.reset();
      }
      if (hasLeft) {
        hasLeft = false;
        busy++;
      }
    }

    @Override
    public void await(long deadline) throws InterruptedException {
      synchronized (lock) {
        rejoin();
        if (goesOn()) {
          return;
        }
        begin(deadline);
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

    /** Whether a wait returns immediately: signalled meanwhile, or closed. */
    private boolean goesOn() {
      // A thread joins the order at its first wait, so it yields its turn even if a signal
      // is pending.
      boolean goesOn = closed || signalled && hasWaited;
      signalled &= !goesOn;
      return goesOn;
    }

    private void begin(long deadline) {
      hasWaited = true;
      deadlineMicros = deadline;
      wait.begin();
      busy--;
      if (signalled) {
        signal();
      }
    }

    @Override
    public void lend(Turns lent) throws InterruptedException {
      LentTurns mine = new LentTurns(lent, this::goesOn);
      long next = lent.take();
      while (next != Turns.OVER) {
        next = isLent(mine, next) && awaitReturn(mine) ? Turns.OVER : lent.take();
      }
    }

    private boolean isLent(LentTurns mine, long deadline) {
      synchronized (lock) {
        if (goesOn()) {
          return false;
        }
        if (loan == null) {
          carriers.join();
        }
        loan = mine;
        isLent = true;
        mine.begin();
        begin(deadline);
        passTurnIfIdle();
        return true;
      }
    }

    /** Blocks until the turns are returned to the lender. Returns whether they are over. */
    private boolean awaitReturn(LentTurns mine) throws InterruptedException {
      while (mine.isLent()) {
        mine.await();
        if (Thread.interrupted()) {
          synchronized (lock) {
            if (isLent) {
              take();
              throw new InterruptedException();
            }
            mine.passInterruptOn();
          }
        }
      }
      return mine.isOver();
    }

    private boolean goesOn(LentTurns lent) {
      synchronized (lock) {
        boolean isEnding = lent.isEnding();
        if (!isEnding && !closed && goesOn()) {
          return true;
        }
        carriers.release(lent);
        if (isEnding || closed) {
          lent.giveBack(); // including the turn
        } else {
          isLent = true;
          begin(lent.deadlineMicros());
          passTurnIfIdle();
        }
        return false;
      }
    }

    /** Starts the turn, on a carrier if lent. */
    private void grant() {
      boolean isCarried = isLent;
      take();
      if (isCarried) {
        carriers.carry(loan);
      }
    }

    private void take() {
      ready.remove(this);
      queued = false;
      signalled = false;
      isLent = false;
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
            callAhead(); // call later threads once this one has its turn
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
        if (isLent) {
          loan.giveBack();
        }
        if (wait.isWaiting()) {
          take(); // its thread returns from its wait and ends; time no longer waits for it
        }
        if (loan != null) {
          carriers.leave();
        }
        turns.remove(this);
        unreliable.remove(this);
        if (!hasLeft) {
          busy--;
        }
        passTurnIfIdle();
      }
    }
  }
}
