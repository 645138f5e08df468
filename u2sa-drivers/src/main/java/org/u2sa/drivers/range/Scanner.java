package org.u2sa.drivers.range;

import java.util.List;
import org.u2sa.messages.frame.Point;

/**
 * All that {@link LidarSensor} knows of a scanning laser. Belongs to one thread; no call waits for
 * the device.
 */
interface Scanner extends AutoCloseable {
  /**
   * The newest whole scan.
   *
   * @param measuredAtMicros when its end came, time of the run's clock [µs]; grows with each scan
   * @param points that were seen, in the sensor's axes: x ahead, y left [m]; may be empty
   */
  record Reading(long measuredAtMicros, List<Point> points) {}

  /** Before anything was scanned. */
  Reading NONE = new Reading(Long.MIN_VALUE, List.of());

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
