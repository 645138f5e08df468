package org.u2sa.device;

import java.util.OptionalDouble;

/** A pitot tube with a static port, and the pressure sensor between the two. */
public interface PitotTube extends Device<PitotTube.Impact> {
  /**
   * What the air does to it.
   *
   * @param differentialPa total less static pressure [Pa]; a little below 0 at rest by noise
   * @param staticPa static pressure [Pa]; empty if it is not measured
   * @param temperatureK of the outside air [K]; empty if it is not measured
   */
  record Impact(
      long measuredAtMicros,
      double differentialPa,
      OptionalDouble staticPa,
      OptionalDouble temperatureK)
      implements Reading {}
}
