package org.u2sa.device.port;

import org.u2sa.messages.RangeScan;

/** A scanning range finder. Closing it stops its motor and its laser. */
public interface LaserScanner extends Device<LaserScanner.Scan> {
  /**
   * One complete scan.
   *
   * @param measuredAtMicros time of its last beam
   * @param beams all beams, with the time of the first [µs], in the scanner's own axes: x ahead, y
   *     left; without the sensor's name and mounting
   */
  record Scan(long measuredAtMicros, RangeScan beams) implements Reading {}
}
