package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import java.util.EnumSet;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.device.port.GpsFix;
import org.u2sa.drivers.gps.NmeaGps;
import org.u2sa.drivers.gps.UbxGps;
import org.u2sa.drivers.link.ByteParser;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.sensor.GpsMessage;
import org.u2sa.sim.sensor.GpsParameters;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.sensor.UbloxReceiver;
import org.u2sa.sim.sensor.UbloxSettings;
import org.u2sa.sim.sensor.UtcTime;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;

/** The drivers understand the simulated receiver, and what they make of its bytes is the truth. */
class SimulatedGpsTest {
  private static final double EAST_MPS = 1.2;
  private static final double NORTH_MPS = -0.5;
  private static final double SPEED_MPS = Math.hypot(EAST_MPS, NORTH_MPS);
  private static final double DRIVEN_S = 120.0;
  private static final LocalPlane PLANE = new LocalPlane(new Geodetic(-80.42, 37.23, 600.0));

  static Stream<Arguments> receivers() {
    UbloxSettings pvt = new UbloxSettings(38_400, 10.0, EnumSet.of(GpsMessage.PVT), 5);
    return Stream.of(
        Arguments.of(UbloxSettings.binary(9_600, 8.0), new UbxGps(), 0.20),
        Arguments.of(UbloxSettings.binary(38_400, 10.0), new UbxGps(), 0.11),
        Arguments.of(pvt, new UbxGps(), 0.11),
        Arguments.of(UbloxSettings.precise(38_400, 10.0), new NmeaGps(), 0.14),
        Arguments.of(UbloxSettings.factory(), new NmeaGps(), 0.35));
  }

  @ParameterizedTest
  @MethodSource("receivers")
  void accept_movingReceiver_givesPlaceVelocityAndSigma(
      UbloxSettings settings, ByteParser<GpsFix> parser, double longestLagS) {
    UtcTime utc = new UtcTime(Instant.parse("2026-06-01T23:59:30Z")); // past midnight
    UbloxReceiver receiver =
        new UbloxReceiver(settings, GpsParameters.survey(), PLANE, utc, new NoiseStreams(11L));
    byte[] buffer = new byte[64];
    GpsFix last = null;
    int fixes = 0;
    double lagS = 0.0;
    double across2 = 0.0;
    for (long us = 0; us < DRIVEN_S * 1e6; us += 1_000) {
      receiver.advance(us, truth(us * 1e-6), false);
      int count = receiver.line().take(us, settings.baud(), buffer);
      parser.accept(buffer, count, us);
      GpsFix fix = parser.latest().orElse(null);
      if (fix != last) {
        last = fix;
        fixes++;
        Point error = error(fix);
        lagS -= (error.x() * EAST_MPS + error.y() * NORTH_MPS) / (SPEED_MPS * SPEED_MPS);
        double across = (error.y() * EAST_MPS - error.x() * NORTH_MPS) / SPEED_MPS;
        across2 += across * across;
        assertThat(fix.valid()).isTrue();
        assertThat(fix.eastMps().orElseThrow()).isCloseTo(EAST_MPS, within(0.2));
        assertThat(fix.northMps().orElseThrow()).isCloseTo(NORTH_MPS, within(0.2));
      }
    }
    assertThat(parser.refused()).isZero();
    assertThat((double) fixes)
        .isBetween(DRIVEN_S * settings.rateHz() - 2, DRIVEN_S * settings.rateHz() + 1);
    assertThat(lagS / fixes).isBetween(0.06, longestLagS);
    assertThat(Math.sqrt(across2 / fixes)).isBetween(0.01, 0.035);
    assertThat(last.horizontalSigmaM().orElseThrow()).isCloseTo(0.02, within(0.002));
    assertThat(last.altitudeM().orElseThrow()).isCloseTo(600.0, within(0.2));
  }

  private static VehicleTruth truth(double timeS) {
    return new VehicleTruth(
        0.0,
        Point.of(EAST_MPS * timeS, NORTH_MPS * timeS, 0.0),
        new Attitude(0.0, 0.0, Math.PI / 2.0),
        Point.of(EAST_MPS, NORTH_MPS, 0.0),
        Point.ORIGIN,
        Point.ORIGIN);
  }

  /** Of the fix's place from where the receiver was when the fix was made of its bytes [m]. */
  private static Point error(GpsFix fix) {
    double seconds = fix.measuredAtMicros() * 1e-6;
    Geodetic truth = PLANE.at(EAST_MPS * seconds, NORTH_MPS * seconds, 0.0);
    return truth.enuOf(new Geodetic(fix.longitudeDeg(), fix.latitudeDeg(), truth.altitudeM()));
  }
}
