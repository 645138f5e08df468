package org.u2sa.device.port;

import java.util.OptionalDouble;

/** A single-beam range finder, such as a sonar. */
public interface RangeFinder extends Device<RangeFinder.Distance> {
  /**
   * The nearest object in the beam.
   *
   * @param rangeM distance from the sensor [m], not negative; empty if nothing is in range
   */
  record Distance(long measuredAtMicros, OptionalDouble rangeM) implements Reading {}
}
