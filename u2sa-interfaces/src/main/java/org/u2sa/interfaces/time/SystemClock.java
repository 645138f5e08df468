package org.u2sa.interfaces.time;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongSupplier;

/**
 * Real time: the machine's monotonic clock, aligned with the time of day once per process, so it
 * never jumps while a vehicle moves. All instances of a process agree, as do those of child
 * processes started with {@link #option}, even if the time of day was changed meanwhile.
 *
 * <p>The only class that calls the system's clock.
 */
public final class SystemClock implements Clock {
  private static final long NANOS_PER_MICRO = 1_000L;
  private static final long LONGEST_PARK_MICROS = 3_600 * MICROS_PER_SECOND; // must fit in ns

  private static final String PROPERTY = "u2sa.time.base";
  private static final TimeBase OF_PROCESS =
      TimeBase.of(System.getProperty(PROPERTY, ""), System::currentTimeMillis, System::nanoTime);

  private final TimeBase base;

  public SystemClock() {
    this(OF_PROCESS);
  }

  private SystemClock(TimeBase base) {
    this.base = base;
  }

  /** Clock with an offset to this one [µs]; positive is ahead. */
  public SystemClock ahead(long offsetMicros) {
    return new SystemClock(new TimeBase(base.zeroMicros() + offsetMicros));
  }

  /** JVM option that gives a child process started now the same time base. */
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

  /** {@inheritDoc} With one core it never spins: no thread could signal meanwhile. */
  @Override
  public Waiter newWaiter(String name, long spinMicros) {
    return new ParkingWaiter(Runtime.getRuntime().availableProcessors() > 1 ? spinMicros : 0L);
  }

  private final class ParkingWaiter implements Waiter {
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
        lookOut(deadlineMicros); // saves the signaller a wake-up
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
              lookOut(deadlineMicros); // to meet the deadline despite wake-up latency
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

    private void lookOut(long deadlineMicros) {
      long until = Math.min(deadlineMicros, micros() + spinMicros);
      for (int looks = 1; !signalled.get() && !closed && micros() < until; looks++) {
        if (looks % LOOKS_BEFORE_YIELD == 0) {
          Thread.yield(); // Android 28 lacks Thread.onSpinWait
        }
      }
    }

    @Override
    public void signal() {
      // An unpark is a system call: a flood of messages to a busy thread needs only one, and
      // most of them need not even write.
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
   * Maps the machine's monotonic clock to the time of day, which is read once per process tree.
   * Where processes do not share the monotonic clock (they do on Linux and Android), an inherited
   * base is implausible and ignored.
   *
   * @param zeroMicros time of day when the monotonic clock read 0 [µs since 1970-01-01T00:00Z]
   */
  record TimeBase(long zeroMicros) {
    /** Maximum age of an inherited base. */
    private static final long STARTS_WITHIN_NANOS = 600_000_000_000L;

    private static final long NANOS_PER_MICRO = 1_000L;
    private static final long MICROS_PER_MILLI = 1_000L;

    /**
     * @param handed {@link #text} of the parent process; empty if none
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
          return now(timeOfDayMillis, monotonicNanos); // belongs to a different clock
        }
      }
      return now(timeOfDayMillis, monotonicNanos);
    }

    private static TimeBase now(LongSupplier timeOfDayMillis, LongSupplier monotonicNanos) {
      long monotonicMicros = monotonicNanos.getAsLong() / NANOS_PER_MICRO;
      return new TimeBase(timeOfDayMillis.getAsLong() * MICROS_PER_MILLI - monotonicMicros);
    }

    long micros(long monotonicNanos) {
      return zeroMicros + monotonicNanos / NANOS_PER_MICRO;
    }

    String text(long monotonicNanos) {
      return zeroMicros + "," + monotonicNanos;
    }
  }
}
