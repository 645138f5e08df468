package org.u2sa.interfaces.time;

import java.util.function.LongSupplier;

/**
 * Which time of day a reading of the machine's monotonic clock is. It is taken once a process, and
 * handed on to the processes that this one starts, so that none of them notices when somebody sets
 * the machine's time of day. On Linux and Android the monotonic clock is one for all processes of a
 * machine; where it is not, what was handed on shows that and is left out.
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
