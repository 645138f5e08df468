package org.u2sa.interfaces.time;

import java.util.concurrent.locks.LockSupport;

/**
 * One thread's wait for its turn on a {@link LockstepClock}: asleep, or spinning for a few
 * microseconds once it was called ahead. Guarded by the clock's lock, except {@link #await}.
 */
final class TurnWait {
  /** About the latency of waking a thread; spinning longer gains nothing. */
  private static final long LOOKS_OUT_MICROS = 20;

  /** Spin iterations between two yields to other threads, possibly the one that has the turn. */
  private static final int LOOKS_BEFORE_YIELD = 32;

  private static final Clock MACHINE = new SystemClock();

  private volatile boolean waiting;
  private volatile boolean called;
  private volatile Thread asleep; // null while the thread is awake

  boolean isWaiting() {
    return waiting;
  }

  void begin() {
    called = false;
    waiting = true;
  }

  void end() {
    waiting = false;
    wake();
  }

  /** Wakes the thread to spin, because its turn is next. */
  void callAhead() {
    called = true;
    wake();
  }

  private void wake() {
    Thread sleeper = asleep;
    if (sleeper != null) {
      asleep = null; // wake only once: it is a system call
      LockSupport.unpark(sleeper);
    }
  }

  /** Blocks until the wait is ended or the thread is interrupted; called by that thread. */
  void await() {
    Thread thread = Thread.currentThread();
    while (waiting && !thread.isInterrupted()) {
      if (called) {
        called = false;
        lookOut();
      } else {
        asleep = thread;
        if (waiting && !called) { // checked after asleep is set, to miss no wake-up
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
        Thread.yield(); // Android 28 lacks Thread.onSpinWait
      }
    }
  }
}
