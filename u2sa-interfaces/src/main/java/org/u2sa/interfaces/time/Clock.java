package org.u2sa.interfaces.time;

/**
 * The time source of a run, and the only way a service's thread waits.
 *
 * <p>All services of a system share one clock. Because waiting is a call on the clock, the same
 * service runs in real time ({@link SystemClock}) and in simulated time ({@link LockstepClock})
 * without knowing which.
 */
public interface Clock {
  /** Microseconds in a second: message timestamps are in microseconds. */
  long MICROS_PER_SECOND = 1_000_000L;

  /** A deadline that is never reached. */
  long NEVER = Long.MAX_VALUE;

  /**
   * Current time [µs]: since 1970-01-01T00:00Z in real time, since the start of the run in
   * simulated time.
   */
  long micros();

  /** Whether time is frozen while threads work. */
  default boolean isSimulated() {
    return false;
  }

  /**
   * Creates a waiter for one thread.
   *
   * @param name name for diagnostics
   */
  Waiter newWaiter(String name);

  /**
   * {@link #newWaiter(String)} for a low-latency thread: in real time it spins (busy-waits) at the
   * start of a wait and before a deadline.
   *
   * @param spinMicros maximum spin time per wait [µs]; 0 to not spin
   */
  default Waiter newWaiter(String name, long spinMicros) {
    return newWaiter(name);
  }

  /**
   * {@link #newWaiter(String)} for a thread that may also block elsewhere, such as in {@link
   * Thread#sleep}; simulated time then advances without it.
   *
   * @param thread started after this call
   * @param outOfStep called by the driving thread when that first happens
   */
  default Waiter newWaiter(Thread thread, Runnable outOfStep) {
    return newWaiter(thread.getName());
  }

  /** The thread that {@linkplain Waiter#lend lent} the current turn, or else the calling thread. */
  static Thread runningThread() {
    return Thread.currentThread() instanceof TurnThread carrier
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

  /** The work a thread does between its waits, one turn at a time. */
  @FunctionalInterface
  interface Turns {
    /** Return value that ends the turns. */
    long OVER = Long.MIN_VALUE;

    /**
     * Runs one turn.
     *
     * @return deadline of the next turn [µs] or {@link Clock#NEVER}; a signal starts it earlier;
     *     {@link #OVER} at the end
     */
    long take() throws InterruptedException;
  }

  /** The waiting point of one thread, which alone may call {@link #await} and {@link #lend}. */
  interface Waiter extends AutoCloseable {
    /**
     * Waits for a {@link #signal} since the last wait, or for the deadline.
     *
     * @param deadlineMicros time of this clock [µs], or {@link Clock#NEVER}
     * @throws InterruptedException if the waiting thread was interrupted
     */
    void await(long deadlineMicros) throws InterruptedException;

    /**
     * Runs turns until they end, {@linkplain #await waiting} between them.
     *
     * <p>The clock may run some of them on its own thread while this one is blocked in the call.
     * Turns run one at a time, each sees the writes of earlier ones, and no lock may be held
     * between turns. Interrupting this thread interrupts the running turn.
     *
     * @throws InterruptedException if this thread was interrupted, or a turn threw it; any other
     *     exception of a turn is rethrown here
     */
    default void lend(Turns turns) throws InterruptedException {
      for (long next = turns.take(); next != Turns.OVER; next = turns.take()) {
        await(next);
      }
    }

    /** Ends the current wait, or the next one if the thread is not waiting. Never blocks. */
    void signal();

    /**
     * Releases the waiter: waits return immediately, and a simulation advances without this thread.
     */
    @Override
    void close();
  }
}
