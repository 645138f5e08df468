package org.u2sa.device.port;

import java.util.Optional;

/**
 * Port of one kind of device, so that a service treats serial, network, phone, simulated and
 * replayed devices alike. Not thread-safe.
 *
 * @param <R> type of its readings
 */
public interface Device<R extends Device.Reading> extends Attached, AutoCloseable {
  /** A timestamped measurement. */
  interface Reading {
    /** Time of the measurement, or of the arrival of its bytes [µs of the run's clock]. */
    long measuredAtMicros();
  }

  /**
   * Reads the device. Returns immediately and never throws for a lost device.
   *
   * @param nowMicros the time now [µs of the run's clock], never less than at the last call
   * @return the latest reading, repeated until a newer one arrives, even while the device is lost;
   *     empty before the first
   */
  Optional<R> read(long nowMicros);

  /** Number of malformed messages and missing replies so far. */
  default long malformed() {
    return 0;
  }

  /** Why the last of {@link #malformed} was rejected; empty if unknown. */
  default String lastRefusal() {
    return "";
  }

  @Override
  default boolean isConnected() {
    return true;
  }

  @Override
  default int connections() {
    return 1;
  }

  @Override
  default String trouble() {
    return "";
  }

  @Override
  default void close() {}
}
