package org.u2sa.interfaces.time;

import java.util.concurrent.locks.LockSupport;

/**
 * Where one thread waits for its turn on a {@link LockstepClock}: asleep, or, once it was called
 * ahead, awake for a few microseconds. All but {@link #await} belongs to whoever holds the clock's
 * lock.
 */
final class TurnWait {
  /** About what it takes to wake a thread: to look out for longer than that gains nothing. */
  private static final long LOOKS_OUT_MICROS = 20;

  /** Looks between two offers of the core to other threads, which may include who has the turn. */
  private static final int LOOKS_BEFORE_YIELD = 32;

  private static final Clock MACHINE = new SystemClock();

  private volatile boolean waiting;
  private volatile boolean called;
  private volatile Thread asleep; // null while the thread is awake

  /** Whether the thread has yet to get its turn. */
  boolean isWaiting() {
    return waiting;
  }

  /** Takes note that the thread is going to {@link #await} its turn. */
  void begin() {
    called = false;
    waiting = true;
  }

  /** Ends the wait. */
  void end() {
    waiting = false;
    wake();
  }

  /** Has the thread look out, as its turn comes soon. */
  void callAhead() {
    called = true;
    wake();
  }

  private void wake() {
    Thread sleeper = asleep;
    if (sleeper != null) {
      asleep = null; // woken once: that is a call of the operating system
      LockSupport.unpark(sleeper);
    }
  }

  /** Returns when the wait was ended or the thread interrupted; called by that thread. */
  void await() {
    Thread thread = Thread.currentThread();
    while (waiting && !thread.isInterrupted()) {
      if (called) {
        called = false;
        lookOut();
      } else {
        asleep = thread;
        if (waiting && !called) { // asked after it is known to sleep, so that no wake is missed
          LockSupport.park(this);
        }
        asleep = null;
      }
    }
  }

  private void lookOut() {
    long until = MACHINE.micros() + LOOKS_OUT_MICROS;
    for (int looks = 1; waiting && MACHINE.micros() < until; looks++) {
      if (looks % LOOKS_BEFORE_YIELD == 0) {
        Thread.yield(); // Android 28 has no gentler way, Thread.onSpinWait
      }
    }
  }
}
