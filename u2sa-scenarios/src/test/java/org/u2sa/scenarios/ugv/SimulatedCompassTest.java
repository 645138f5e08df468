package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.device.port.Heading;
import org.u2sa.drivers.compass.NmeaCompass;
import org.u2sa.drivers.compass.SpartonCompass;
import org.u2sa.drivers.link.ByteParser;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.MagneticModel;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.sensor.CompassModel;
import org.u2sa.sim.sensor.CompassParameters;
import org.u2sa.sim.sensor.NmeaCompassDevice;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.sensor.SpartonDevice;
import org.u2sa.sim.vehicle.VehicleTruth;

/** The drivers understand the simulated compasses, and true north comes out again. */
class SimulatedCompassTest {
  private static final int BAUD = 9_600;
  private static final double DECLINATION =
      MagneticModel.declinationRad(37.23, -80.42, 600.0, 2026.4);
  private static final CompassParameters PERFECT = CompassParameters.perfect(DECLINATION);
  private final byte[] buffer = new byte[256];

  @ParameterizedTest
  @ValueSource(doubles = {0.0, 0.01, 1.5, 3.1416, 4.7, 6.283})
  void accept_spartonAsked_answersTheMagneticHeading(double trueRad) {
    SpartonDevice device = new SpartonDevice(BAUD, PERFECT, new NoiseStreams(1L));
    device.advance(0, facing(trueRad), CompassModel.Disturbance.none());
    byte[] request = SpartonCompass.request();
    device.accept(0, BAUD, request, request.length);
    ByteParser<Heading> parser = new SpartonCompass();
    parser.accept(buffer, device.line().take(20_000, BAUD, buffer), 20_000);
    assertTrueHeading(parser, trueRad, Math.PI / 4096.0);
  }

  @ParameterizedTest
  @EnumSource
  void accept_nmeaCompass_isUnderstoodInAllItsSentences(NmeaCompassDevice.Sentence sentence) {
    for (double trueRad : new double[] {0.0, 0.01, 1.5, 3.1416, 4.7, 6.283}) {
      NmeaCompassDevice device =
          new NmeaCompassDevice(BAUD, sentence, PERFECT, new NoiseStreams(1L));
      device.advance(0, facing(trueRad), CompassModel.Disturbance.none());
      ByteParser<Heading> parser = NmeaCompass.parser();
      parser.accept(buffer, device.line().take(50_000, BAUD, buffer), 50_000);
      assertTrueHeading(parser, trueRad, Math.toRadians(0.051));
    }
  }

  private static VehicleTruth facing(double headingRad) {
    return new VehicleTruth(
        0.0,
        Point.of(0, 0, 0),
        new Attitude(0.0, 0.0, headingRad),
        Point.of(0, 0, 0),
        Point.ORIGIN,
        Point.ORIGIN);
  }

  private static void assertTrueHeading(ByteParser<Heading> parser, double trueRad, double within) {
    Heading heading = parser.latest().orElseThrow();
    double declination = heading.isTrue() ? 0.0 : DECLINATION;
    double error = heading.headingRad() + declination - trueRad;
    assertThat(Math.IEEEremainder(error, 2.0 * Math.PI)).isCloseTo(0.0, within(within));
    assertThat(parser.refused()).isZero();
  }
}
