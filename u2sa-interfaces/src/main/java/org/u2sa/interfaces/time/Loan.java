package org.u2sa.interfaces.time;

import java.lang.reflect.UndeclaredThrowableException;
import java.util.function.Predicate;

/**
 * Turns that a thread lent to a {@link LockstepClock}, until it gets them back. Carriers take them
 * meanwhile, one at a time. All but {@link #carry} and what belongs to the lender belongs to
 * whoever holds the clock's lock.
 */
final class Loan {
  private final Thread lender = Thread.currentThread();
  private final TurnWait wait = new TurnWait(); // the lender's
  private final Clock.Turns turns;
  private final Predicate<Loan> goesOn;
  private TurnCarriers.Carrier carrier; // while it takes a turn; otherwise null
  private long deadlineMicros; // what follows is the outcome of the last turn
  private Throwable thrown;
  private boolean interrupted;

  /**
   * Turns that the calling thread is going to lend.
   *
   * @param goesOn asked on the carrier after each turn, whether it is to take the next one
   */
  Loan(Clock.Turns turns, Predicate<Loan> goesOn) {
    this.turns = turns;
    this.goesOn = goesOn;
  }

  Thread lender() {
    return lender;
  }

  /** Lends the turns. */
  void begin() {
    wait.begin();
  }

  /** A carrier takes the turn; null: none does any more. */
  void carriedBy(TurnCarriers.Carrier taker) {
    carrier = taker;
  }

  TurnCarriers.Carrier carrier() {
    return carrier;
  }

  /** Takes turns on the calling thread, a carrier, as long as it goes on. */
  void carry() {
    do {
      try {
        deadlineMicros = turns.take();
      } catch (Throwable e) { // comes out of the lender's call, as if it had taken the turn
        thrown = e;
      }
    } while (goesOn.test(this));
  }

  /** Whether the lender has to go on itself after this turn; asked on the carrier, once a turn. */
  boolean isEnding() {
    interrupted = Thread.interrupted();
    return interrupted || thrown != null || deadlineMicros == Clock.Turns.OVER;
  }

  /** Until when to wait for the next turn [µs]. */
  long deadlineMicros() {
    return deadlineMicros;
  }

  /** Ends the loan: the lender goes on by itself. */
  void giveBack() {
    carrier = null;
    wait.end();
  }

  /** Has an interrupt of the lender, which calls this, reach the code that runs for it. */
  void passInterruptOn() {
    if (carrier == null) {
      lender.interrupt();
    } else {
      carrier.interrupt();
    }
  }

  /** Returns when the loan was given back or the thread interrupted; called by the lender. */
  void await() {
    wait.await();
  }

  /** Whether the lender has yet to be given its turns back. */
  boolean isLent() {
    return wait.isWaiting();
  }

  /**
   * Whether the last turn was the last of all; for the lender, after it was given back.
   *
   * @throws InterruptedException if that turn threw it, or was interrupted and did not end them
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
