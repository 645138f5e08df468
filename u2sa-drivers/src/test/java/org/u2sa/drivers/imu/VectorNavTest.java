package org.u2sa.drivers.imu;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.device.port.Heading;
import org.u2sa.device.port.Orientation;
import org.u2sa.drivers.nmea.Nmea;
import org.u2sa.drivers.nmea.NmeaParser;
import org.u2sa.messages.frame.Point;

/** Lines that real VN-100 sent, as users of it and the maker's own examples quote them. */
class VectorNavTest {
  private static final Heading NORTH = Heading.ofDegrees(0, 0.0, true);
  private static final String LEVEL =
      "$VNYMR,+100.949,-007.330,+000.715,-00.0049,-00.2449,+00.5397,-01.258,-00.100,-09.701,-00.000018,+00.001122,-00.000551*69";
  private static final String INVERTED =
      "$VNYMR,-004.328,+001.357,+178.257,+00.2219,-00.0720,+00.4652,+00.226,-00.321,+10.043,-00.001188,+00.001866,-00.007661*6C";
  private static final String STEEP =
      "$VNYMR,-165.981,-037.301,+001.245,+00.2901,+00.0720,+00.7482,-05.966,-00.150,-07.836,+00.001373,-00.001533,-00.001054*68";
  private static final String BANKED =
      "$VNYMR,-078.104,+005.642,+023.096,+00.0125,+00.1252,-00.1042,+00.878,-03.762,-08.854,-00.010387,-00.028062,-00.061305*68";

  private final NmeaParser<Orientation> imu = VectorNav.parser();

  private void hear(String text) {
    byte[] bytes = text.getBytes(US_ASCII);
    imu.accept(bytes, bytes.length, 5_000);
  }

  @Test
  void accept_realLine_isUnderstood() {
    hear(BANKED + "\r\n");

    Orientation said = imu.latest().orElseThrow();
    assertThat(Math.toDegrees(said.heading().headingRad())).isCloseTo(281.896, within(1e-9));
    assertThat(said.heading().isTrue()).isFalse();
    assertThat(Math.toDegrees(said.pitchRad())).isCloseTo(5.642, within(1e-9));
    assertThat(Math.toDegrees(said.rollRad())).isCloseTo(23.096, within(1e-9));
    assertThat(said.xRateRadPerS()).isEqualTo(-0.010387);
    assertThat(said.yRateRadPerS()).isEqualTo(-0.028062);
    assertThat(said.zRateRadPerS()).isEqualTo(-0.061305);
    assertThat(said.measuredAtMicros()).isEqualTo(5_000);
  }

  /**
   * At rest the line's own acceleration is that of lying as the line says: the senses are right.
   */
  @ParameterizedTest
  @ValueSource(strings = {LEVEL, INVERTED, STEEP, BANKED})
  void accept_realLineAtRest_attitudeAgreesWithItsAcceleration(String line) {
    hear(line + "\r\n");

    Orientation said = imu.latest().orElseThrow();
    String[] fields = line.split("[,*]");
    double g = 9.81;
    assertThat(Double.parseDouble(fields[7])).isCloseTo(g * Math.sin(said.pitchRad()), within(0.3));
    assertThat(Double.parseDouble(fields[8]))
        .isCloseTo(-g * Math.sin(said.rollRad()) * Math.cos(said.pitchRad()), within(0.3));
    assertThat(Double.parseDouble(fields[9]))
        .isCloseTo(-g * Math.cos(said.rollRad()) * Math.cos(said.pitchRad()), within(0.3));
    assertThat(imu.refused()).isZero();
  }

  @Test
  void accept_outOfRange_isRefused() {
    hear(Nmea.line("VNYMR,181.0,0,0,0,0,0,0,0,0,0,0,0"));
    hear(Nmea.line("VNYMR,0,91.0,0,0,0,0,0,0,0,0,0,0"));
    hear(Nmea.line("VNYMR,0,0,0,0,0,0,0,0,0,0,0,41"));
    hear(Nmea.line("VNYMR,0,0,0,0,0,0,0,0,0,0,0"));
    hear(Nmea.line("VNYMR,NaN,0,0,0,0,0,0,0,0,0,0,0"));

    assertThat(imu.latest()).isEmpty();
    assertThat(imu.refused()).isEqualTo(5);
    assertThat(imu.lastRefusal()).startsWith("yaw NaN is outside ±180.0: $VNYMR,NaN");
  }

  @Test
  void accept_otherMessages_arePassedOver() {
    hear("$VNRRG,01,VN-200T-CR*31\r\n");

    assertThat(imu.latest()).isEmpty();
    assertThat(imu.refused()).isZero();
  }

  @Test
  void rates_banked_areThoseOfTheAngles() {
    // in a level turn at 30 deg of bank the heading turns at Ω, and p = 0, q = Ω sin φ, r = Ω cos φ
    double bank = Math.toRadians(30.0);
    double turn = 0.2;
    Orientation said =
        new Orientation(0, bank, 0.0, NORTH, 0.0, turn * Math.sin(bank), turn * Math.cos(bank));

    Point rates = said.eulerRates().orElseThrow();
    assertThat(rates.z()).isCloseTo(turn, within(1e-12));
    assertThat(rates.y()).isCloseTo(0.0, within(1e-12));
    assertThat(rates.x()).isCloseTo(0.0, within(1e-12));
  }

  @Test
  void rates_straightUp_areNotKnown() {
    double up = Math.PI / 2.0;
    assertThat(new Orientation(0, 0.0, up, NORTH, 0.1, 0.1, 0.1).eulerRates()).isEmpty();
  }
}
