package org.u2sa.planning.station;

import org.u2sa.interfaces.time.Clock;

/**
 * Reports that a vehicle at a station waits for what is in its way: once, and again only after it
 * has not waited for a while, because what it sees is noisy. Not thread-safe.
 */
public final class StationWait {
  private static final long AGAIN_MICROS = 10 * Clock.MICROS_PER_SECOND;
  private static final long NEVER = Long.MIN_VALUE / 2;

  private long waitedMicros = NEVER; // newest state in which it waited

  /** Begins a station. */
  public void begin() {
    waitedMicros = NEVER;
  }

  /** The report on a vehicle that begins to wait; otherwise empty. */
  public String remark(boolean waits, long nowMicros) {
    boolean isNews = waits && nowMicros - waitedMicros > AGAIN_MICROS;
    waitedMicros = waits ? nowMicros : waitedMicros;
    return isNews ? "waits: something is where it would move or turn" : "";
  }
}
