package org.u2sa.service;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;

/**
 * Tells a service's thread the time between its author's callbacks, and how long each takes, with
 * as few looks at the machine's clock as that needs: a look takes longer than to hand a message on.
 *
 * <p>What ends one callback begins the next one, if nothing but the way to it is between them. In
 * real time it is the time of the run as well. In a simulation the two have nothing to do with each
 * other: how long code takes is real time there too.
 */
final class CallbackStopwatch {
  private final Clock run;
  private final Clock real; // the same in real time
  private long lastMicros; // of real; touched by the service's thread only
  private boolean isFresh; // likewise: lastMicros is as good as now

  CallbackStopwatch(Clock run) {
    this(run, run instanceof SystemClock ? run : new SystemClock());
  }

  /** With the real time of a clock that a test has. */
  CallbackStopwatch(Clock run, Clock real) {
    this.run = run;
    this.real = real;
  }

  /** The time of the run [µs]. */
  long runMicros() {
    return run == real ? realMicros() : run.micros();
  }

  /** The real time [µs]. */
  long realMicros() {
    return isFresh ? lastMicros : look();
  }

  /** The real time at which a callback begins [µs]. */
  long begin() {
    long now = realMicros();
    isFresh = false; // it may take long
    return now;
  }

  /** The real time at which a callback has ended [µs]. */
  long end() {
    return look();
  }

  private long look() {
    lastMicros = real.micros();
    isFresh = true;
    return lastMicros;
  }

  /** Takes note that something else takes time before the next callback. */
  void pause() {
    isFresh = false;
  }

  /** The real time [µs], for other threads than the service's. */
  long realMicrosElsewhere() {
    return real.micros();
  }
}
