package org.u2sa.drivers.compass;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.device.port.Heading;
import org.u2sa.drivers.nmea.Nmea;
import org.u2sa.drivers.nmea.NmeaParser;

class NmeaCompassTest {
  private static final double TINY = 1e-9;

  private final NmeaParser<Heading> compass = NmeaCompass.parser();

  private void hear(String... bodies) {
    byte[] bytes = Nmea.bytes(bodies);
    compass.accept(bytes, bytes.length, 5_000);
  }

  private Heading heading() {
    return compass.latest().orElseThrow();
  }

  @Test
  void accept_hdm_isMagnetic() {
    hear("HCHDM,101.5,M");

    assertThat(heading().headingRad()).isCloseTo(Math.toRadians(101.5), within(TINY));
    assertThat(heading().isTrue()).isFalse();
    assertThat(heading().measuredAtMicros()).isEqualTo(5_000);
  }

  @Test
  void accept_hdt_isTrue() {
    hear("HEHDT,359.9,T");

    assertThat(heading().headingRad()).isCloseTo(Math.toRadians(359.9), within(TINY));
    assertThat(heading().isTrue()).isTrue();
  }

  @Test
  void accept_hdg_deviationIsAddedAndVariationLeft() {
    hear("HCHDG,001.0,3.0,W,7.1,W");

    assertThat(heading().headingRad()).isCloseTo(Math.toRadians(358.0), within(TINY));
    assertThat(heading().isTrue()).isFalse();
  }

  @Test
  void accept_hdgWithHeadingOnly_isTaken() {
    hear("HCHDG,101.1,,,,");

    assertThat(heading().headingRad()).isCloseTo(Math.toRadians(101.1), within(TINY));
  }

  @Test
  void accept_outOfRangeOrEmpty_isRefused() {
    hear("HCHDM,360.1,M", "HCHDM,-1,M", "HCHDT,,T", "HCHDM,north,M", "HCHDG,,,,,");

    assertThat(compass.latest()).isEmpty();
    assertThat(compass.refused()).isEqualTo(5);
    assertThat(compass.lastRefusal()).startsWith("no heading: $HCHDG");
  }

  @Test
  void accept_otherSentences_arePassedOver() {
    hear("GPRMC,120000.00,A,3713.5000,N,08025.2000,W,10.0,90.0,211126,,,A", "HCXDR,A,1.0,D,PITCH");

    assertThat(compass.latest()).isEmpty();
    assertThat(compass.refused()).isZero();
  }
}
