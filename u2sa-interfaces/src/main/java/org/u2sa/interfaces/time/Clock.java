package org.u2sa.interfaces.time;

/**
 * The time of a run, and the only way in which a service's thread waits.
 *
 * <p>All services of a system share one clock. Because waiting is a call on the clock, the same
 * service runs in real time ({@link SystemClock}) and in simulated time ({@link LockstepClock})
 * without knowing which.
 */
public interface Clock {
  /** Microseconds in a second: message timestamps are in microseconds. */
  long MICROS_PER_SECOND = 1_000_000L;

  /** A deadline that never comes. */
  long NEVER = Long.MAX_VALUE;

  /**
   * The time now [µs]: since 1970-01-01T00:00Z in real time, since the start of the run in
   * simulated time.
   */
  long micros();

  /**
   * Makes the means by which one thread waits on this clock.
   *
   * @param name who waits, for diagnostics
   */
  Waiter newWaiter(String name);

  /**
   * {@link #newWaiter(String)} for a thread that is to react at once: in real time it looks out for
   * a while before it sleeps, which takes that much of a core, and again before a deadline. In
   * simulated time this is left out.
   *
   * @param name who waits, for diagnostics
   * @param spinMicros how long it looks out at most, each time [µs]; 0: not at all
   */
  default Waiter newWaiter(String name, long spinMicros) {
    return newWaiter(name);
  }

  /**
   * {@link #newWaiter(String)} for a thread whose code may also wait elsewhere, such as in {@link
   * Thread#sleep} or for a device. Simulated time goes on without the thread meanwhile.
   *
   * @param thread who waits; started after this
   * @param outOfStep called when simulated time first goes on without the thread, by whoever drives
   *     the clock
   */
  default Waiter newWaiter(Thread thread, Runnable outOfStep) {
    return newWaiter(thread.getName());
  }

  /**
   * The thread whose code the calling one runs: the one that {@linkplain Waiter#lend lent} its
   * turns, if a clock takes one of them on another thread; otherwise the calling one itself.
   */
  static Thread runningThread() {
    return Thread.currentThread() instanceof TurnCarriers.Carrier carrier
        ? carrier.lender()
        : Thread.currentThread();
  }

  /** The given time or span in seconds. */
  static double seconds(long micros) {
    return micros / (double) MICROS_PER_SECOND;
  }

  /** The given time or span in microseconds, rounded to the nearest. */
  static long micros(double seconds) {
    return Math.round(seconds * MICROS_PER_SECOND);
  }

  /** What a thread does between its waits, one turn at a time. */
  @FunctionalInterface
  interface Turns {
    /** Says that no further turn follows. */
    long OVER = Long.MIN_VALUE;

    /**
     * Does what there is to do now.
     *
     * @return time of the clock [µs] until which to wait for the next turn, unless a signal comes
     *     first, or {@link Clock#NEVER}; {@link #OVER} at the end
     * @throws InterruptedException if the thread was interrupted
     */
    long take() throws InterruptedException;
  }

  /**
   * One thread's place to wait. {@link #await} and {@link #lend} belong to that thread, the other
   * calls to anyone.
   */
  interface Waiter extends AutoCloseable {
    /**
     * Waits until {@link #signal} was called since the last wait, or until the clock reaches the
     * deadline.
     *
     * @param deadlineMicros time of this clock [µs], or {@link Clock#NEVER}
     * @throws InterruptedException if the waiting thread was interrupted
     */
    void await(long deadlineMicros) throws InterruptedException;

    /**
     * Takes turns until they are over, and {@linkplain #await waits} between them.
     *
     * <p>The thread lends its turns: a clock may take some on a thread of its own while this one
     * waits for the call to return. One turn is taken at a time, each sees what those before it
     * wrote, and no lock must be held from one to the next. An interrupt of this thread reaches the
     * turn that is being taken. {@link Clock#runningThread} is this thread in all of them.
     *
     * @throws InterruptedException if this thread was interrupted, or a turn threw it; whatever
     *     else a turn throws comes out here, too
     */
    default void lend(Turns turns) throws InterruptedException {
      for (long next = turns.take(); next != Turns.OVER; next = turns.take()) {
        await(next);
      }
    }

    /** Ends the present wait, or the next one if the thread is not waiting. Never blocks. */
    void signal();

    /**
     * Gives the place up: waits end at once from now on, and a simulation goes on without this
     * thread. Safe to call twice.
     */
    @Override
    void close();
  }
}
