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
public abstract class ByteParser<R> {
  private Optional<R> latest = Optional.empty();
  private long refused;
  private String lastRefusal = "";

  /**
   * Consumes bytes.
   *
   * @param length number of valid {@code bytes}
   * @param nowMicros arrival time [µs, run's clock], used as the readings' time
   */
  public abstract void accept(byte[] bytes, int length, long nowMicros);

  /**
   * Discards a partial message, for example after a loss of the device; the latest reading is kept.
   */
  public abstract void reset();

  /** Replaces the latest reading. */
  protected final void found(R reading) {
    latest = Optional.of(reading);
  }

  /** Counts a rejected message. */
  protected final void refuse(String why) {
    refused++;
    lastRefusal = why;
  }

  /** Latest reading; empty before the first. The same object until the next reading. */
  public Optional<R> latest() {
    return latest;
  }

  /** Number of messages rejected: wrong checksum, truncated, out of range. */
  public final long refused() {
    return refused;
  }

  /** Reason of the last rejection, for the log; empty if none. */
  public final String lastRefusal() {
    return lastRefusal;
  }
}
