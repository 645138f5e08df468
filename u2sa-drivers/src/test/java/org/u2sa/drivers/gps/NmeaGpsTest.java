package org.u2sa.drivers.gps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.device.port.GpsFix;
import org.u2sa.drivers.nmea.Nmea;

class NmeaGpsTest {
  private static final double ONE_KNOT_MPS = 0.514444;

  private final NmeaGps gps = new NmeaGps(4.0);
  private long now = 1_000_000;

  private void hear(String... bodies) {
    for (String body : bodies) {
      byte[] bytes = Nmea.bytes(body);
      gps.accept(bytes, bytes.length, now);
      now += 10_000;
    }
  }

  private GpsFix fix() {
    return gps.latest().orElseThrow();
  }

  private static String rmc(String time) {
    return "GPRMC," + time + ",A,3713.5000,N,08025.2000,W,10.0,90.0,211126,,,A";
  }

  private static String gga(String time) {
    return "GPGGA," + time + ",3713.5000,N,08025.2000,W,1,08,1.5,634.2,M,-33.0,M,,";
  }

  @Test
  void accept_rmcAndGga_makeOneFixWhenBothAreThere() {
    hear(rmc("120000.00"), gga("120000.00"));
    assertThat(gps.latest()).as("which sentence is the last is not known yet").isEmpty();
    hear(rmc("120001.00"));
    GpsFix first = fix();
    hear(gga("120001.00"));

    assertThat(fix()).isNotSameAs(first);
    assertThat(fix().measuredAtMicros()).as("when its first sentence came").isEqualTo(1_020_000);
    assertThat(fix().latitudeDeg()).isCloseTo(37.225, within(1e-9));
    assertThat(fix().longitudeDeg()).isCloseTo(-80.42, within(1e-9));
    assertThat(fix().altitudeM()).hasValue(634.2);
    assertThat(fix().eastMps().orElseThrow()).isCloseTo(10 * ONE_KNOT_MPS, within(1e-4));
    assertThat(fix().northMps().orElseThrow()).isCloseTo(0.0, within(1e-9));
    assertThat(fix().upMps()).isEmpty();
    assertThat(fix().satellites()).isEqualTo(8);
    assertThat(fix().valid()).isTrue();
  }

  @Test
  void accept_gst_givesSigmas() {
    // the example of u-blox's protocol specification GPS.G6-SW-10018
    byte[] example = "$GPGST,082356.00,1.8,,,,1.7,1.3,2.2*7E\r\n".getBytes();
    gps.accept(example, example.length, now);
    hear(rmc("120000.00"), gga("120000.00"), rmc("120001.00"));

    assertThat(fix().horizontalSigmaM().orElseThrow())
        .isCloseTo(Math.sqrt((1.7 * 1.7 + 1.3 * 1.3) / 2), within(1e-9));
    assertThat(fix().verticalSigmaM()).hasValue(2.2);
  }

  @Test
  void accept_gsaWithoutGst_sigmasFollowFromDilution() {
    hear("GPGSA,A,3,05,07,08,10,15,17,18,19,30,,,,2.5,2.0,1.5");
    hear(rmc("120000.00"), gga("120000.00"), rmc("120001.00"));

    assertThat(fix().horizontalSigmaM().orElseThrow())
        .isCloseTo(4.0 * 2.0 / Math.sqrt(2), within(1e-9));
    assertThat(fix().verticalSigmaM()).hasValue(4.0 * 1.5);
  }

  private static String gga(String time, int quality) {
    return gga(time).replace(",W,1,", ",W," + quality + ",").replace(",1.5,634", ",1.0,634");
  }

  private static String rmc(String time, String mode) {
    return rmc(time).replace(",,,A", ",,," + mode);
  }

  /** The figures of {@link FixQuality}'s sources, for HDOP 1 and RANGE ERROR 4 m. */
  @ParameterizedTest
  @CsvSource({"1, A, 4.0", "2, D, 2.4", "3, P, 4.0", "4, R, 0.024", "5, F, 0.6"})
  void accept_qualityWithoutGst_sigmaIsThatOfTheSolution(
      int quality, String mode, double rangeErrorM) {
    hear(gga("120000.00", quality), gga("120001.00", quality), gga("120002.00", quality));
    assertThat(fix().horizontalSigmaM().orElseThrow())
        .isCloseTo(rangeErrorM / Math.sqrt(2), within(1e-9));
    assertThat(fix().valid()).isTrue();

    hear("GPGSA,A,3,05,07,08,10,15,17,18,19,30,,,,2.5,1.0,2.0");
    hear(rmc("120003.00", mode), rmc("120004.00", mode), rmc("120005.00", mode));
    assertThat(fix().horizontalSigmaM().orElseThrow())
        .as("by RMC alone")
        .isCloseTo(rangeErrorM / Math.sqrt(2), within(1e-9));
    assertThat(fix().verticalSigmaM().orElseThrow()).isCloseTo(2.0 * rangeErrorM, within(1e-9));
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 6, 7, 8})
  void accept_qualityThatIsNoMeasurement_isNoFix(int quality) {
    hear(gga("120000.00", quality), gga("120001.00", quality));
    assertThat(fix().valid()).isFalse();
  }

  @Test
  void accept_worseReceiverThanItsRtk_isNotMadeWorse() {
    NmeaGps good = new NmeaGps(0.5);
    byte[] bytes = Nmea.bytes(gga("120000.00", 5));
    good.accept(bytes, bytes.length, now);
    bytes = Nmea.bytes(gga("120001.00", 5));
    good.accept(bytes, bytes.length, now);
    assertThat(good.latest().orElseThrow().horizontalSigmaM().orElseThrow())
        .isCloseTo(0.5 / Math.sqrt(2), within(1e-9));
  }

  @Test
  void accept_rtkSaidAsDgpsByRmc_ggaCounts() { // as receivers with NMEA 2.3 do
    for (String time : new String[] {"120000.00", "120001.00", "120002.00"}) {
      hear(rmc(time, "D"), gga(time, 4));
    }
    assertThat(fix().horizontalSigmaM().orElseThrow())
        .isCloseTo(0.024 / Math.sqrt(2), within(1e-9));
  }

  @Test
  void accept_rtkLost_itsGstIsForgottenAtOnce() {
    for (String time : new String[] {"120000.00", "120001.00", "120002.00"}) {
      hear(gga(time, 4), "GPGST," + time + ",1.8,,,,0.01,0.01,0.02");
    }
    hear(gga("120003.00", 4));
    assertThat(fix().horizontalSigmaM().orElseThrow()).isCloseTo(0.01, within(1e-9));
    hear(gga("120004.00", 1));
    assertThat(fix().horizontalSigmaM().orElseThrow()).isCloseTo(4.0 / Math.sqrt(2), within(1e-9));
  }

  @Test
  void accept_gstNoLongerSent_isForgotten() {
    hear("GPGST,120000.00,1.8,,,,0.1,0.1,0.1");
    for (int second = 0; second < 20; second++) {
      String time = "1200" + (10 + second) + ".00";
      hear(rmc(time), gga(time));
    }

    assertThat(fix().horizontalSigmaM().orElseThrow())
        .as("from GGA's dilution")
        .isCloseTo(4.0 * 1.5 / Math.sqrt(2), within(1e-9));
    assertThat(fix().verticalSigmaM()).isEmpty();
  }

  @Test
  void accept_ggaAndVtgOnly_velocityIsOfVtg() {
    for (String time : new String[] {"120000.00", "120001.00", "120002.00"}) {
      hear("GPVTG,180.0,T,,M,2.0,N,3.7,K,A", gga(time));
    }

    assertThat(fix().northMps().orElseThrow()).isCloseTo(-2 * ONE_KNOT_MPS, within(1e-4));
    assertThat(fix().eastMps().orElseThrow()).isCloseTo(0.0, within(1e-9));
  }

  @Test
  void accept_standingWithoutCourse_velocityIsZero() {
    String standing = "GPRMC,%s,A,3713.5000,N,08025.2000,W,0.02,,211126,,,A";
    hear(String.format(standing, "120000.00"), String.format(standing, "120001.00"));

    assertThat(fix().eastMps()).hasValue(0.0);
    assertThat(fix().northMps()).hasValue(0.0);
  }

  @Test
  void accept_movingWithoutCourse_velocityIsUnknown() {
    String moving = "GPRMC,%s,A,3713.5000,N,08025.2000,W,9.9,,211126,,,A";
    hear(String.format(moving, "120000.00"), String.format(moving, "120001.00"));

    assertThat(fix().eastMps()).isEmpty();
    assertThat(fix().valid()).isTrue();
  }

  @Test
  void accept_noFix_isNotValid() {
    hear("GPRMC,,V,,,,,,,,,,N", "GPGGA,,,,,,0,03,,,M,,M,,", "GPRMC,,V,,,,,,,,,,N");

    assertThat(fix().valid()).isFalse();
    assertThat(fix().satellites()).isEqualTo(3);
    assertThat(gps.refused()).isZero();
  }

  @Test
  void accept_oneSentenceSaysNotValid_fixIsNot() {
    for (int second = 0; second < 3; second++) {
      String time = "12000" + second + ".00";
      hear(gga(time), rmc(time).replace(",A,3713", ",V,3713"));
      assertThat(gps.latest().filter(GpsFix::valid)).isEmpty();
    }
    assertThat(fix().satellites()).isEqualTo(8);
  }

  @Test
  void accept_estimatedPosition_isNotValid() {
    String estimated = "GPRMC,%s,A,3713.5000,N,08025.2000,W,1.0,10.0,211126,,,E";
    hear(String.format(estimated, "120000.00"), String.format(estimated, "120001.00"));

    assertThat(fix().valid()).isFalse();
  }

  @Test
  void accept_outOfRange_isRefusedAndTheFixKept() {
    hear(rmc("120000.00"), rmc("120001.00"), rmc("120002.00"));
    GpsFix before = fix();
    hear(
        "GPRMC,120003.00,A,9913.5000,N,08025.2000,W,10.0,90.0,211126,,,A",
        "GPRMC,120003.00,A,3713.5000,N,19925.2000,W,10.0,90.0,211126,,,A",
        "GPRMC,120003.00,A,3713.5000,N,08025.2000,W,99999,90.0,211126,,,A",
        "GPRMC,120003.00,A,3713.5000,N,08025.2000,W,10.0,900.0,211126,,,A",
        "GPRMC,120003.00,A,,,,,10.0,90.0,211126,,,A",
        "GPGGA,120003.00,3713.5000,N,08025.2000,W,1,08,1.5,999999,M,-33.0,M,,");

    assertThat(fix()).isSameAs(before);
    assertThat(gps.refused()).isEqualTo(6);
    assertThat(gps.lastRefusal()).contains("altitude 999999.0 is outside -1000.0…100000.0");
  }

  @Test
  void accept_closingSentenceLost_fixComesWithTheNextTimeAndItsOwn() {
    hear(rmc("120000.00"), gga("120000.00"), rmc("120001.00"), gga("120001.00"));
    long heard = now;
    hear(rmc("120002.00")); // its GGA is lost
    assertThat(fix().measuredAtMicros()).isLessThan(heard);
    hear(rmc("120003.00"));

    assertThat(fix().measuredAtMicros()).isEqualTo(heard);
    assertThat(fix().altitudeM()).isEmpty();
  }

  @Test
  void accept_otherConstellations_areUnderstood() {
    for (String talker : new String[] {"GN", "GL", "GA", "GB", "BD", "GQ", "QZ", "GI"}) {
      hear(rmc("120000.00").replace("GPRMC", talker + "RMC"));
      hear(rmc("120001.00").replace("GPRMC", talker + "RMC"));
    }

    assertThat(gps.refused()).isZero();
  }
}
