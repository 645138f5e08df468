package org.u2sa.drivers.link;

import java.util.Optional;

/**
 * Parses a device's bytes, independent of transport. Input boundaries are arbitrary and bytes may
 * be garbage: malformed data is counted and skipped.
 *
 * <p>Not thread-safe.
 *
 * @param <R> reading type
 */
public interface ByteParser<R> {
  /**
   * Consumes bytes.
   *
   * @param length number of valid {@code bytes}
   * @param nowMicros arrival time [µs, run's clock], used as the time of the readings
   */
  void accept(byte[] bytes, int length, long nowMicros);

  /**
   * Discards a partial message, for example after a loss of the device; the latest reading is kept.
   */
  void reset();

  /** Latest reading; empty before the first. The same object until the next reading. */
  Optional<R> latest();

  /** Number of messages rejected: wrong checksum, truncated, out of range. */
  long refused();

  /** Reason of the last rejection, for the log; empty if none. */
  String lastRefusal();
}
