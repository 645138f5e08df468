package org.u2sa.interfaces.time;

import java.lang.reflect.UndeclaredThrowableException;
import java.util.function.Predicate;

/**
 * The turns a thread has lent to a {@link LockstepClock}; carriers run them one at a time until
 * they are returned. Guarded by the clock's lock, except {@link #carry} and the methods of the
 * lender.
 */
final class LentTurns {
  private final Thread lender = Thread.currentThread();
  private final TurnWait wait = new TurnWait(); // owned by the lender
  private final Clock.Turns turns;
  private final Predicate<LentTurns> goesOn;
  private LentTurnThreads.Carrier carrier; // running a turn; null if none
  private long deadlineMicros; // this and the fields below: outcome of the last turn
  private Throwable thrown;
  private boolean interrupted;

  /**
   * @param goesOn evaluated on the carrier after each turn: whether it also runs the next turn
   */
  LentTurns(Clock.Turns turns, Predicate<LentTurns> goesOn) {
    this.turns = turns;
    this.goesOn = goesOn;
  }

  Thread lender() {
    return lender;
  }

  void begin() {
    wait.begin();
  }

  void carriedBy(LentTurnThreads.Carrier taker) {
    carrier = taker;
  }

  LentTurnThreads.Carrier carrier() {
    return carrier;
  }

  /** Runs turns on the calling carrier thread while it may continue. */
  void carry() {
    do {
      try {
        deadlineMicros = turns.take();
      } catch (Throwable e) { // rethrown on the lender
        thrown = e;
      }
    } while (goesOn.test(this));
  }

  /** Whether the lender must continue by itself; called on the carrier, once per turn. */
  boolean isEnding() {
    interrupted = Thread.interrupted();
    return interrupted || thrown != null || deadlineMicros == Clock.Turns.OVER;
  }

  long deadlineMicros() {
    return deadlineMicros;
  }

  void giveBack() {
    carrier = null;
    wait.end();
  }

  /** Forwards an interrupt of the lender to the running turn. */
  void passInterruptOn() {
    if (carrier == null) {
      lender.interrupt();
    } else {
      carrier.interrupt();
    }
  }

  /** Blocks the lender until the loan is returned or the thread is interrupted. */
  void await() {
    wait.await();
  }

  boolean isLent() {
    return wait.isWaiting();
  }

  /**
   * Whether the turns are over; called by the lender after the loan was returned.
   *
   * @throws InterruptedException if a turn threw it, or was interrupted and did not end them
   */
  boolean isOver() throws InterruptedException {
    if (thrown instanceof Error error) {
      throw error;
    }
    if (thrown instanceof RuntimeException exception) {
      throw exception;
    }
    if (thrown instanceof InterruptedException exception) {
      throw exception;
    }
    if (thrown != null) { // an undeclared checked one
      throw new UndeclaredThrowableException(thrown);
    }
    boolean isOver = deadlineMicros == Clock.Turns.OVER;
    if (interrupted && !isOver) {
      throw new InterruptedException();
    }
    if (interrupted) {
      lender.interrupt();
    }
    return isOver;
  }
}
