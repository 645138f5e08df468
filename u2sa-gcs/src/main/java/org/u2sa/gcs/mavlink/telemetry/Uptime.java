package org.u2sa.gcs.mavlink.telemetry;

import java.util.function.LongSupplier;

/** Time since the bridge started, reported as the time since the autopilot booted. */
public final class Uptime {
  private static final long MILLI = 1000;

  private final LongSupplier clock;
  private final long beganMicros;

  /**
   * @param clock real time [µs]
   */
  public Uptime(LongSupplier clock) {
    this.clock = clock;
    beganMicros = clock.getAsLong();
  }

  /** Time since the start [µs]. */
  public long micros() {
    return clock.getAsLong() - beganMicros;
  }

  /** Time since the start [ms], in 32 bits. */
  public long millis() {
    return micros() / MILLI & 0xFFFF_FFFFL;
  }

  /** Wall clock [µs since 1970]. */
  public long unixMicros() {
    return clock.getAsLong();
  }
}
