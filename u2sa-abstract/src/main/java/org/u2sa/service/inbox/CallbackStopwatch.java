package org.u2sa.service.inbox;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;

/**
 * Provides the time between an author's callbacks and their durations with a minimum of
 * system-clock reads, because one read costs more than delivering a message.
 *
 * <p>The end time of one callback is reused as the start of the next if nothing happens in between,
 * and, in real time, as the time of the run. In a simulation the two clocks are unrelated, because
 * durations are still measured in real time.
 */
public final class CallbackStopwatch {
  private final Clock run;
  private final Clock real; // the same in real time
  private long lastMicros; // of real; touched by the service's thread only
  private boolean isFresh; // likewise: lastMicros is still current

  /**
   * @param run clock of the run
   */
  public CallbackStopwatch(Clock run) {
    this(run, run instanceof SystemClock ? run : new SystemClock());
  }

  /** Uses a test's clock as real time. */
  public CallbackStopwatch(Clock run, Clock real) {
    this.run = run;
    this.real = real;
  }

  /** The time of the run [µs]. */
  public long runMicros() {
    return run == real ? realMicros() : run.micros();
  }

  /** The real time [µs]. */
  long realMicros() {
    return isFresh ? lastMicros : look();
  }

  /** The real time at which a callback begins [µs]. */
  public long begin() {
    long now = realMicros();
    isFresh = false; // a callback may be slow
    return now;
  }

  /** The real time at which a callback has ended [µs]. */
  public long end() {
    return look();
  }

  private long look() {
    lastMicros = real.micros();
    isFresh = true;
    return lastMicros;
  }

  /** Invalidates the cached time before other slow work. */
  public void pause() {
    isFresh = false;
  }

  /** The real time [µs], for threads other than the service's. */
  public long realMicrosElsewhere() {
    return real.micros();
  }
}
