package org.u2sa.device;

import java.util.OptionalDouble;

/** A range finder with one beam, such as a sonar. */
public interface RangeFinder extends Device<RangeFinder.Distance> {
  /**
   * The nearest thing in the beam.
   *
   * @param rangeM distance from the sensor [m], 0 or more; empty if nothing is in reach
   */
  record Distance(long measuredAtMicros, OptionalDouble rangeM) implements Reading {}
}
