package org.u2sa.interfaces.time;

/**
 * Tells whether a thread that has its turn on a {@link LockstepClock} waits for something else.
 * Looked at regularly while the turn lasts. Belongs to whoever holds the clock's lock.
 */
final class StepWatch {
  /** Looks in a row that find the thread asleep: a lock or a log file is waited for briefly. */
  private static final int ASLEEP_LOOKS = 3;

  /** Looks at a thread that seems to compute, but may block in a system call or loop for ever. */
  private static final int BUSY_LOOKS = 200;

  private final Thread thread;
  private final Runnable outOfStep;
  private int looks; // in this turn
  private int asleep; // of them in a row
  private boolean hasTold;

  /**
   * @param outOfStep called when the thread first waits for something else
   */
  StepWatch(Thread thread, Runnable outOfStep) {
    this.thread = thread;
    this.outOfStep = outOfStep;
  }

  /** Takes note that the thread waits for the clock. */
  void reset() {
    looks = 0;
    asleep = 0;
  }

  /** Looks once. */
  boolean isElsewhere() {
    Thread.State state = thread.getState();
    if (state == Thread.State.TERMINATED) {
      return true;
    }
    boolean isAsleep = state == Thread.State.TIMED_WAITING || state == Thread.State.WAITING;
    asleep = isAsleep ? asleep + 1 : 0;
    looks++;
    boolean isElsewhere = asleep >= ASLEEP_LOOKS || looks >= BUSY_LOOKS;
    if (isElsewhere && !hasTold) {
      hasTold = true;
      outOfStep.run();
    }
    return isElsewhere;
  }
}
