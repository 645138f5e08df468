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

  /** The given time or span in seconds. */
  static double seconds(long micros) {
    return micros / (double) MICROS_PER_SECOND;
  }

  /** The given time or span in microseconds, rounded to the nearest. */
  static long micros(double seconds) {
    return Math.round(seconds * MICROS_PER_SECOND);
  }

  /**
   * One thread's place to wait. {@link #await} belongs to that thread, the other calls to anyone.
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
