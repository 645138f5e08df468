package org.u2sa.device.port;

import java.util.OptionalDouble;

/** A pitot tube with a static port, and the pressure sensor between the two. */
public interface PitotTube extends Device<PitotTube.Impact> {
  /**
   * Pressures and temperature of the air.
   *
   * @param differentialPa total minus static pressure [Pa]; may be slightly negative at rest
   *     because of noise
   * @param staticPa static pressure [Pa]; empty if not measured
   * @param temperatureK temperature of the outside air [K]; empty if not measured
   */
  record Impact(
      long measuredAtMicros,
      double differentialPa,
      OptionalDouble staticPa,
      OptionalDouble temperatureK)
      implements Reading {}
}
