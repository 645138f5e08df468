package org.u2sa.device;

import java.util.Optional;

/**
 * A port: all that a service knows of one kind of device. Devices on a serial line or a network,
 * the phone's, simulated and replayed ones look alike through it. Belongs to one thread.
 *
 * @param <R> what it reads
 */
public interface Device<R extends Device.Reading> extends Attached, AutoCloseable {
  /** What a device measured at one moment. */
  interface Reading {
    /** Time of the measurement, or of the arrival of its bytes [µs of the run's clock]. */
    long measuredAtMicros();
  }

  /**
   * Reads the device. Returns at once and never throws for a lost device.
   *
   * @param nowMicros the time now [µs of the run's clock], never less than at the last call
   * @return the newest reading: the same one until there is a newer one, also while the device is
   *     lost; empty before the first
   */
  Optional<R> read(long nowMicros);

  /** Number of messages so far that could not be read, and of answers that did not come. */
  default long malformed() {
    return 0;
  }

  /** Why the last of {@link #malformed} could not be read; empty if that is not known. */
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
