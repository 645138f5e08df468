package org.u2sa.sim.aircraft;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.sf.geographiclib.Geodesic;
import net.sf.geographiclib.GeodesicData;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.sim.atmosphere.Wind;

class PositionTest {
  private static final double ALTITUDE_M = 500.0;
  private static final double DT_S = 0.05;

  // Straight flight follows a geodesic; GeographicLib computes it independently.
  @ParameterizedTest
  @CsvSource({
    "21.3, -157.9, 0",
    "47.0, 8.0, 45",
    "64.0, -22.6, 90",
    "-33.9, 151.2, 250",
    "0, 179.8, 90"
  })
  void step_100Kilometres_endsWhereTheGeodesicDoes(double lat, double lon, double headingDeg) {
    Trim trim = Trim.level(ALTITUDE_M, 60.0, 0.0);
    Cessna172 aircraft =
        Cessna172.inFlight(trim.start(lon, lat, 0.0, Math.toRadians(headingDeg)), Wind.calm());
    double flownM = 0.0;
    AircraftMotion state = aircraft.state();
    while (flownM < 100_000.0) {
      double course =
          Geodesic.WGS84.Inverse(lat, lon, state.latitudeDeg(), state.longitudeDeg()).azi2;
      double wanted = flownM < 100.0 ? headingDeg : course; // along the geodesic from the start
      double error =
          Math.toRadians(Math.IEEEremainder(wanted - Math.toDegrees(state.headingRad()), 360.0));
      double aileron =
          trim.controls().aileron() + error - 2.0 * state.rollRad() - 0.5 * state.rollRateRadPerS();
      aircraft.step(
          trim.controls()
              .withSurfaces(aileron, trim.controls().elevator(), trim.controls().rudder()),
          DT_S);
      AircraftMotion next = aircraft.state();
      flownM += DT_S * 0.5 * (groundSpeed(state) + groundSpeed(next));
      state = next;
    }
    GeodesicData line = Geodesic.WGS84.Inverse(lat, lon, state.latitudeDeg(), state.longitudeDeg());
    double atHeight = line.s12 * (1.0 + ALTITUDE_M / 6_371_000.0);
    assertThat(atHeight).isCloseTo(flownM, within(3.0));
    double courseError = Math.IEEEremainder(line.azi1 - headingDeg, 360.0);
    assertThat(courseError).isCloseTo(0.0, within(1.0));
  }

  private static double groundSpeed(AircraftMotion state) {
    return Math.hypot(state.velocityNorthMps(), state.velocityEastMps());
  }
}
