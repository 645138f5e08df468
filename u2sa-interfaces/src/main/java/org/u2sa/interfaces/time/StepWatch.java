package org.u2sa.interfaces.time;

/**
 * Detects whether a thread that has its turn on a {@link LockstepClock} blocks elsewhere. Guarded
 * by the clock's lock.
 */
final class StepWatch {
  /** Consecutive polls that must find it asleep; waits for locks and log files are shorter. */
  private static final int ASLEEP_LOOKS = 3;

  /** Polls of a thread that seems to run, but may block in a system call or loop forever. */
  private static final int BUSY_LOOKS = 200;

  private final Thread thread;
  private final Runnable outOfStep;
  private int looks; // polls in this turn
  private int asleep; // consecutive polls that found it asleep
  private boolean hasTold;

  StepWatch(Thread thread, Runnable outOfStep) {
    this.thread = thread;
    this.outOfStep = outOfStep;
  }

  void reset() {
    looks = 0;
    asleep = 0;
  }

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
