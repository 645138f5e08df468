package org.u2sa.service.inbox;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;

/**
 * Measures callbacks with few system-clock reads, because one costs more than delivering a message:
 * the end of one callback is reused as the start of the next and, in real time, as the time of the
 * run. Durations are in real time, also in a simulation.
 */
public final class CallbackStopwatch {
  private final Clock run;
  private final Clock real; // the same in real time
  private long lastMicros; // real time; touched by the service's thread only
  private boolean isFresh; // likewise: lastMicros is still current

  public CallbackStopwatch(Clock run) {
    this(run, run instanceof SystemClock ? run : new SystemClock());
  }

  public CallbackStopwatch(Clock run, Clock real) {
    this.run = run;
    this.real = real;
  }

  /** The time of the run [µs]. */
  public long runMicros() {
    return run == real ? realMicros() : run.micros();
  }

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
