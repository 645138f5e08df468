package org.u2sa.drivers.traffic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.u2sa.device.port.TrafficTarget;

/** The examples of the specification itself (560-1058-00 Rev A, 2.2.4 and 3.5.4). */
class Gdl90ParserTest {
  private static final String EXAMPLE_HEARTBEAT = "7E 00 81 41 DB D0 08 02 B3 8B 7E";
  static final byte[] EXAMPLE_REPORT =
      hex("14 00 AB 45 49 1F EF 15 A8 89 78 0F 09 A9 07 B0 01 20 01 4E 38 32 35 56 20 20 20 00");

  private final Gdl90Parser parser = new Gdl90Parser();

  private static byte[] hex(String text) {
    String[] parts = text.split(" ");
    byte[] bytes = new byte[parts.length];
    for (int i = 0; i < bytes.length; i++) {
      bytes[i] = (byte) Integer.parseInt(parts[i], 16);
    }
    return bytes;
  }

  /** Flags, escapes and a CRC by table, apart from the parser's. */
  static byte[] framed(byte[] message) {
    int crc = 0;
    for (byte each : message) {
      int t = 0;
      for (int bit = 0, c = crc >> 8 << 8; bit < 8; bit++) {
        c = (c << 1 ^ ((c & 0x8000) != 0 ? 0x1021 : 0)) & 0xFFFF;
        t = c;
      }
      crc = t ^ crc << 8 & 0xFFFF ^ each & 0xFF;
    }
    ByteArrayOutputStream framed = new ByteArrayOutputStream();
    framed.write(0x7E);
    for (byte each : message) {
      escape(framed, each);
    }
    escape(framed, (byte) crc);
    escape(framed, (byte) (crc >> 8));
    framed.write(0x7E);
    return framed.toByteArray();
  }

  private static void escape(ByteArrayOutputStream to, byte each) {
    if (each == 0x7D || each == 0x7E) {
      to.write(0x7D);
      to.write(each ^ 0x20);
    } else {
      to.write(each);
    }
  }

  private void hear(byte[] bytes, long nowMicros) {
    parser.accept(bytes, bytes.length, nowMicros);
  }

  private TrafficTarget only() {
    assertThat(parser.latest().orElseThrow().targets()).hasSize(1);
    return parser.latest().orElseThrow().targets().get(0);
  }

  @Test
  void accept_exampleHeartbeat_isRightAndSaysThatTheReceiverLives() {
    hear(hex(EXAMPLE_HEARTBEAT), 5);
    assertThat(parser.refused()).isZero();
    assertThat(parser.latest().orElseThrow().measuredAtMicros()).isEqualTo(5);
    assertThat(parser.latest().orElseThrow().targets()).isEmpty();
  }

  @Test
  void accept_exampleTrafficReport_isTheAircraftThatTheSpecificationDescribes() {
    hear(framed(EXAMPLE_REPORT), 7);
    TrafficTarget target = only();
    assertThat(target.id()).as("octal 52642511").isEqualTo("AB4549");
    assertThat(Integer.parseInt(target.id(), 16)).isEqualTo(052642511);
    assertThat(target.name()).isEqualTo("N825V");
    assertThat(target.latitudeDeg()).isCloseTo(44.90708, within(2.2e-5));
    assertThat(target.longitudeDeg()).isCloseTo(-122.99488, within(2.2e-5));
    assertThat(target.altitudeM().orElseThrow()).isCloseTo(5_000 * 0.3048, within(1e-9));
    assertThat(target.isPressureAltitude()).isTrue();
    double knots = 123.0 * 1852.0 / 3600.0;
    assertThat(target.velocity().orElseThrow().x()).isCloseTo(knots * Math.sqrt(0.5), within(1e-6));
    assertThat(target.velocity().orElseThrow().z()).isCloseTo(64 * 0.3048 / 60, within(1e-9));
    // NACp 9: 95 % within 30 m, σ of each axis 30 / 2.448
    assertThat(target.horizontalSigmaM().orElseThrow()).isCloseTo(12.26, within(0.01));
    assertThat(target.heardAtMicros()).isEqualTo(7);
  }

  @Test
  void accept_absentNumbers_areEmpty() {
    byte[] report = EXAMPLE_REPORT.clone();
    report[11] = (byte) 0xFF; // no altitude
    report[12] = (byte) 0xF9;
    report[13] = (byte) 0xA0; // accuracy unknown
    report[14] = (byte) 0xFF; // no speed
    report[15] = (byte) 0xF8;
    report[16] = 0;
    hear(framed(report), 1);
    assertThat(only().altitudeM()).isEmpty();
    assertThat(only().velocity()).isEmpty();
    assertThat(only().horizontalSigmaM()).isEmpty();
  }

  @Test
  void accept_headingInsteadOfTrack_isNoVelocity() {
    byte[] report = EXAMPLE_REPORT.clone();
    report[12] = 0x0A;
    hear(framed(report), 1);
    assertThat(only().velocity()).isEmpty();
  }

  @Test
  void accept_descent_isNegative() {
    byte[] report = EXAMPLE_REPORT.clone();
    report[15] = (byte) 0xBF; // −2 steps of 64 ft/min
    report[16] = (byte) 0xFE;
    hear(framed(report), 1);
    assertThat(only().velocity().orElseThrow().z()).isCloseTo(-128 * 0.3048 / 60, within(1e-9));
  }

  @Test
  void accept_noPosition_isNoTarget() {
    byte[] report = EXAMPLE_REPORT.clone();
    for (int i = 5; i < 11; i++) {
      report[i] = 0;
    }
    report[13] = 0;
    hear(framed(report), 1);
    assertThat(parser.latest()).isEmpty();
  }

  @Test
  void accept_surfaceTargetWithoutIcaoAddress_hasAnIdOfItsOwn() {
    byte[] report = EXAMPLE_REPORT.clone();
    report[1] = 4;
    hear(framed(report), 1);
    assertThat(only().id()).isEqualTo("4-AB4549");
  }

  @Test
  void accept_ownshipReport_isNoTraffic() {
    byte[] report = EXAMPLE_REPORT.clone();
    report[0] = 10;
    hear(framed(report), 1);
    assertThat(parser.latest()).isEmpty();
    assertThat(parser.refused()).isZero();
  }

  @Test
  void accept_flagsWithinAMessage_areEscaped() {
    byte[] report = EXAMPLE_REPORT.clone();
    report[3] = 0x7E;
    report[4] = 0x7D;
    hear(framed(report), 1);
    assertThat(only().id()).isEqualTo("AB7E7D");
  }

  @Test
  void accept_wrongChecksumOrCut_isRefusedAndTheNextIsHeard() {
    byte[] framed = framed(EXAMPLE_REPORT);
    framed[10] ^= 1;
    hear(framed, 1);
    hear(Arrays.copyOf(framed(EXAMPLE_REPORT), 12), 2);
    assertThat(parser.latest()).isEmpty();
    hear(framed(EXAMPLE_REPORT), 3);
    assertThat(only().heardAtMicros()).isEqualTo(3);
    assertThat(parser.refused()).isEqualTo(2);
  }

  @Test
  void accept_manyTargets_areKeptForAMinuteAndAtMostAThousand() {
    for (int i = 0; i < 1_100; i++) {
      byte[] report = EXAMPLE_REPORT.clone();
      report[3] = (byte) (i >> 8);
      report[4] = (byte) i;
      hear(framed(report), 1);
    }
    assertThat(parser.latest().orElseThrow().targets()).hasSize(1_000);
    hear(framed(EXAMPLE_REPORT), 61_000_001);
    assertThat(parser.latest().orElseThrow().targets()).hasSize(1);
  }
}
