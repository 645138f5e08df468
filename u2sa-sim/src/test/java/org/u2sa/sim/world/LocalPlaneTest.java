package org.u2sa.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.frame.Geodetic;

class LocalPlaneTest {
  // The geodesic of GeographicLib judges: same distance, same direction, to the centimetre at 2 km.
  @ParameterizedTest
  @CsvSource({"37.23, -80.42, 0", "47.0, 8.0, 1", "0, 179.999, 2", "-69.9, 151.2, 4", "80, 0, 5.5"})
  void at_twoKilometres_isWhereTheGeodesicEnds(double lat, double lon, double bearingRad) {
    LocalPlane plane = new LocalPlane(new Geodetic(lon, lat, 0.0));
    Geodetic place = plane.at(2_000.0 * Math.sin(bearingRad), 2_000.0 * Math.cos(bearingRad), 1.5);
    Geodetic expected = plane.origin().destination(bearingRad, 2_000.0);
    assertThat(place.distanceM(expected)).isLessThan(0.01);
    assertThat(place.altitudeM()).isCloseTo(1.5, within(1e-9));
  }
}
