package org.u2sa.drivers.range;

import java.util.OptionalDouble;

/**
 * All that {@link RangeSensor} knows of a range finder with one beam. Belongs to one thread; no
 * call waits for the device.
 */
public interface RangeFinder extends AutoCloseable {
  /**
   * What it measured last.
   *
   * @param measuredAtMicros time of the run's clock [µs]; grows with each measurement
   * @param rangeM distance of the nearest object in the beam [m]; empty if there is none in reach
   */
  record Reading(long measuredAtMicros, OptionalDouble rangeM) {}

  /** Before anything was measured. */
  Reading NONE = new Reading(Long.MIN_VALUE, OptionalDouble.empty());

  /** Hears the device and returns what it measured last. */
  Reading read(long nowMicros);

  /** How often it sent what cannot be read. */
  long malformed();

  @Override
  void close();
}
