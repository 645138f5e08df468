package org.u2sa.sim.sensor;

import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneOffset;

/**
 * Converts simulated time to UTC and GPS time.
 *
 * @param begin UTC instant of simulated time 0
 */
public record UtcTime(Instant begin) {
  private static final long GPS_EPOCH_S = 315_964_800L; // 1980-01-06 in Unix time
  private static final int LEAP_S = 18; // GPS ahead of UTC since 2017
  private static final long WEEK_MS = 7L * 24L * 3_600_000L;
  private static final double MS_PER_S = 1000.0;
  private static final int NS_PER_MS = 1_000_000;

  /** Date and time of day, to the millisecond. */
  LocalDateTime at(double timeS) {
    long ms = begin.toEpochMilli() + Math.round(timeS * MS_PER_S);
    int nano = (int) Math.floorMod(ms, 1000L) * NS_PER_MS;
    return LocalDateTime.ofEpochSecond(Math.floorDiv(ms, 1000L), nano, ZoneOffset.UTC);
  }

  /** GPS time of week, iTOW [ms]. */
  long timeOfWeekMs(double timeS) {
    return Math.floorMod(gpsMs(timeS), WEEK_MS);
  }

  /** GPS week number since 1980-01-06, without roll-over. */
  int week(double timeS) {
    return (int) Math.floorDiv(gpsMs(timeS), WEEK_MS);
  }

  private long gpsMs(double timeS) {
    long unixMs = begin.toEpochMilli() + Math.round(timeS * MS_PER_S);
    return unixMs - GPS_EPOCH_S * 1000L + LEAP_S * 1000L;
  }
}
