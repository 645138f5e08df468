package org.u2sa.drivers.range;

import org.u2sa.messages.RangeScan;

/**
 * All that {@link LidarSensor} knows of a scanning laser. Belongs to one thread; no call waits for
 * the device.
 */
interface Scanner extends AutoCloseable {
  /**
   * The newest whole scan.
   *
   * @param endedAtMicros when its end came, time of the run's clock [µs]; grows with each scan
   * @param beams all of it but whose it is and where the sensor is; with the time of its first beam
   */
  record Reading(long endedAtMicros, RangeScan beams) {}

  /** Before anything was scanned. */
  Reading NONE = new Reading(Long.MIN_VALUE, new RangeScan());

  /** Hears the device, sets it up if need be, and returns the newest whole scan. */
  Reading read(long nowMicros);

  /** How often it sent what cannot be read, or nothing where an answer was due. */
  long malformed();

  /** What the device says is wrong with itself, once; otherwise empty. */
  String trouble();

  /** Stops the device, and closes the link. */
  @Override
  void close();
}
