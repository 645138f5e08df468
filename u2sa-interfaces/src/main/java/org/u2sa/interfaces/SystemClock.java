package org.u2sa.interfaces;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;

/**
 * Real time: the machine's monotonic clock, set once to the time of day, so that it never jumps
 * while a vehicle moves.
 *
 * <p>The only class that calls the system's clock.
 */
public final class SystemClock implements Clock {
  private static final long NANOS_PER_MICRO = 1_000L;
  private static final long MICROS_PER_MILLI = 1_000L;
  private static final long LONGEST_PARK_MICROS = 3_600 * MICROS_PER_SECOND; // in ns it must fit

  private final long startNanos = System.nanoTime();
  private final long startMicros = System.currentTimeMillis() * MICROS_PER_MILLI;

  @Override
  public long micros() {
    return startMicros + (System.nanoTime() - startNanos) / NANOS_PER_MICRO;
  }

  @Override
  public Waiter newWaiter(String name) {
    return new ParkingWaiter();
  }

  private final class ParkingWaiter implements Waiter {
    private final AtomicBoolean signalled = new AtomicBoolean();
    private volatile Thread waiting;
    private volatile boolean closed;

    @Override
    public void await(long deadlineMicros) throws InterruptedException {
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
            LockSupport.parkNanos(
                this, Math.min(leftMicros, LONGEST_PARK_MICROS) * NANOS_PER_MICRO);
          }
        }
      } finally {
        waiting = null;
      }
    }

    @Override
    public void signal() {
      // An unpark is a system call; a flood of messages to a thread that is busy anyway needs one
      // only.
      if (!signalled.getAndSet(true)) {
        LockSupport.unpark(waiting);
      }
    }

    @Override
    public void close() {
      closed = true;
      LockSupport.unpark(waiting);
    }
  }
}
