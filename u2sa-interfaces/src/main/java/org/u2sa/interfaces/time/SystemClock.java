package org.u2sa.interfaces.time;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongSupplier;

/**
 * Real time: the machine's monotonic clock, set to the time of day once a process, so that it never
 * jumps while a vehicle moves. All of a process agree, whenever they were made, and so do those of
 * the processes that it starts with {@link #option}, even if somebody has set the time of day
 * meanwhile.
 *
 * <p>The only class that calls the system's clock.
 */
public final class SystemClock implements Clock {
  private static final long NANOS_PER_MICRO = 1_000L;
  private static final long LONGEST_PARK_MICROS = 3_600 * MICROS_PER_SECOND; // in ns it must fit

  private static final String PROPERTY = "u2sa.time.base";
  private static final TimeBase OF_PROCESS =
      TimeBase.of(System.getProperty(PROPERTY, ""), System::currentTimeMillis, System::nanoTime);

  private final TimeBase base;

  /** The time of this process. */
  public SystemClock() {
    this(OF_PROCESS);
  }

  private SystemClock(TimeBase base) {
    this.base = base;
  }

  /**
   * A clock that is ahead of this one.
   *
   * @param offsetMicros by how much [µs]; negative: behind it
   */
  public SystemClock ahead(long offsetMicros) {
    return new SystemClock(new TimeBase(base.zeroMicros() + offsetMicros));
  }

  /**
   * What a process of this machine that is started now is to be told, so that it agrees with this
   * one on the time: an option of its Java virtual machine.
   */
  public static String option() {
    return "-D" + PROPERTY + "=" + OF_PROCESS.text(System.nanoTime());
  }

  @Override
  public long micros() {
    return base.micros(System.nanoTime());
  }

  @Override
  public Waiter newWaiter(String name) {
    return newWaiter(name, 0L);
  }

  /** {@inheritDoc} With one core it never looks out: nobody could signal meanwhile. */
  @Override
  public Waiter newWaiter(String name, long spinMicros) {
    return new ParkingWaiter(Runtime.getRuntime().availableProcessors() > 1 ? spinMicros : 0L);
  }

  private final class ParkingWaiter implements Waiter {
    /** Looks between two offers of the core to other threads. */
    private static final int LOOKS_BEFORE_YIELD = 64;

    private final AtomicBoolean signalled = new AtomicBoolean();
    private final long spinMicros;
    private volatile Thread waiting;
    private volatile boolean closed;

    ParkingWaiter(long spinMicros) {
      this.spinMicros = spinMicros;
    }

    @Override
    public void await(long deadlineMicros) throws InterruptedException {
      if (spinMicros > 0) {
        lookOut(deadlineMicros); // nobody has to wake the thread meanwhile
      }
      waiting = Thread.currentThread();
      try {
        while (!signalled.getAndSet(false) && !closed) {
          if (Thread.interrupted()) {
            throw new InterruptedException();
          }
          if (deadlineMicros == NEVER) {
            LockSupport.park(this);
          } else {
            long leftMicros = deadlineMicros - micros();
            if (leftMicros <= 0) {
              return;
            }
            if (leftMicros <= spinMicros) {
              lookOut(deadlineMicros); // to be there in time; waking takes a while
            } else {
              long sleepMicros = Math.min(leftMicros - spinMicros, LONGEST_PARK_MICROS);
              LockSupport.parkNanos(this, sleepMicros * NANOS_PER_MICRO);
            }
          }
        }
      } finally {
        waiting = null;
      }
    }

    /** Waits awake for a signal, the deadline or the end of the time to look out. */
    private void lookOut(long deadlineMicros) {
      long until = Math.min(deadlineMicros, micros() + spinMicros);
      for (int looks = 1; !signalled.get() && !closed && micros() < until; looks++) {
        if (looks % LOOKS_BEFORE_YIELD == 0) {
          Thread.yield(); // Android 28 has no gentler way, Thread.onSpinWait
        }
      }
    }

    @Override
    public void signal() {
      // An unpark is a system call; a flood of messages to a thread that is busy anyway needs one
      // only, and most of them need not even write.
      if (!signalled.get() && !signalled.getAndSet(true)) {
        LockSupport.unpark(waiting);
      }
    }

    @Override
    public void close() {
      closed = true;
      LockSupport.unpark(waiting);
    }
  }

  /**
   * Which time of day a reading of the machine's monotonic clock is. It is taken once a process,
   * and handed on to the processes that this one starts, so that none of them notices when somebody
   * sets the machine's time of day. On Linux and Android the monotonic clock is one for all
   * processes of a machine; where it is not, what was handed on shows that and is left out.
   *
   * @param zeroMicros time of day when the monotonic clock read 0 [µs since 1970-01-01T00:00Z]
   */
  record TimeBase(long zeroMicros) {
    /** A process starts within this time of being handed its base, or it is not its own. */
    private static final long STARTS_WITHIN_NANOS = 600_000_000_000L;

    private static final long NANOS_PER_MICRO = 1_000L;
    private static final long MICROS_PER_MILLI = 1_000L;

    /**
     * The base of this process.
     *
     * @param handed what {@link #text} gave in the process that started this one; empty if none did
     * @param timeOfDayMillis the machine's time of day [ms since 1970-01-01T00:00Z]
     * @param monotonicNanos the machine's monotonic clock [ns]
     */
    static TimeBase of(String handed, LongSupplier timeOfDayMillis, LongSupplier monotonicNanos) {
      String[] parts = handed.split(",", -1);
      if (parts.length == 2) {
        try {
          long sinceNanos = monotonicNanos.getAsLong() - Long.parseLong(parts[1]);
          if (sinceNanos >= 0 && sinceNanos <= STARTS_WITHIN_NANOS) {
            return new TimeBase(Long.parseLong(parts[0]));
          }
        } catch (NumberFormatException e) {
          return now(timeOfDayMillis, monotonicNanos); // not ours
        }
      }
      return now(timeOfDayMillis, monotonicNanos);
    }

    private static TimeBase now(LongSupplier timeOfDayMillis, LongSupplier monotonicNanos) {
      long monotonicMicros = monotonicNanos.getAsLong() / NANOS_PER_MICRO;
      return new TimeBase(timeOfDayMillis.getAsLong() * MICROS_PER_MILLI - monotonicMicros);
    }

    /** The time of day at a reading of the monotonic clock [µs since 1970-01-01T00:00Z]. */
    long micros(long monotonicNanos) {
      return zeroMicros + monotonicNanos / NANOS_PER_MICRO;
    }

    /** The base for a process that is started now. */
    String text(long monotonicNanos) {
      return zeroMicros + "," + monotonicNanos;
    }
  }
}
