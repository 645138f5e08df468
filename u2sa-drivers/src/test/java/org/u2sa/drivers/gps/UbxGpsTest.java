package org.u2sa.drivers.gps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.u2sa.device.port.GpsFix;

class UbxGpsTest {
  private static final double MM = 1e-9;

  private final UbxGps gps = new UbxGps();
  private long now = 1_000_000;

  private void hear(byte[] bytes) {
    gps.accept(bytes, bytes.length, now);
    now += 10_000;
  }

  private GpsFix fix() {
    return gps.latest().orElseThrow();
  }

  @Test
  void accept_navPvt_isUnderstoodAsPyubx2MadeIt() {
    hear(UbxGolden.of("NAV-PVT"));

    assertThat(fix().measuredAtMicros()).isEqualTo(1_000_000);
    assertThat(fix().latitudeDeg()).isCloseTo(37.2295733, within(MM));
    assertThat(fix().longitudeDeg()).isCloseTo(-80.4233567, within(MM));
    assertThat(fix().altitudeM().orElseThrow()).isCloseTo(634.251, within(MM));
    assertThat(fix().northMps().orElseThrow()).isCloseTo(1.25, within(MM));
    assertThat(fix().eastMps().orElseThrow()).isCloseTo(-0.75, within(MM));
    assertThat(fix().upMps().orElseThrow()).isCloseTo(0.125, within(MM));
    assertThat(fix().horizontalSigmaM().orElseThrow())
        .as("1.414 m of distance is 1 m along each axis")
        .isCloseTo(1.0, within(1e-3));
    assertThat(fix().verticalSigmaM().orElseThrow()).isCloseTo(2.5, within(MM));
    assertThat(fix().satellites()).isEqualTo(11);
    assertThat(fix().valid()).isTrue();
  }

  @Test
  void accept_navPvtOfUblox7_isUnderstood() {
    byte[] longer = UbxGolden.of("NAV-PVT");
    byte[] payload = Arrays.copyOfRange(longer, 6, 6 + 84);
    hear(UbxFramer.frame(0x01, 0x07, payload));

    assertThat(fix().latitudeDeg()).isCloseTo(37.2295733, within(MM));
  }

  @Test
  void accept_messagesOfLea6_makeOneFixWhenAllAreThere() {
    hear(UbxGolden.of("NAV-POSLLH"));
    hear(UbxGolden.of("NAV-VELNED"));
    assertThat(gps.latest()).as("whether it is valid is not known yet").isEmpty();
    hear(UbxGolden.of("NAV-SOL"));

    assertThat(fix().measuredAtMicros()).as("when the first came").isEqualTo(1_000_000);
    assertThat(fix().latitudeDeg()).isCloseTo(-37.2295733, within(MM));
    assertThat(fix().longitudeDeg()).isCloseTo(-80.4233567, within(MM));
    assertThat(fix().altitudeM().orElseThrow()).isCloseTo(634.251, within(MM));
    assertThat(fix().northMps().orElseThrow()).isCloseTo(1.25, within(MM));
    assertThat(fix().eastMps().orElseThrow()).isCloseTo(-0.75, within(MM));
    assertThat(fix().upMps().orElseThrow()).isCloseTo(0.12, within(MM));
    assertThat(fix().horizontalSigmaM().orElseThrow()).isCloseTo(2.0, within(1e-3));
    assertThat(fix().verticalSigmaM().orElseThrow()).isCloseTo(4.0, within(MM));
    assertThat(fix().satellites()).isEqualTo(9);
  }

  @Test
  void accept_navStatusInPlaceOfNavSol_makesAFix() {
    hear(UbxGolden.of("NAV-STATUS", "NAV-VELNED", "NAV-POSLLH"));

    assertThat(fix().valid()).isTrue();
    assertThat(fix().satellites()).isZero();
  }

  @Test
  void accept_messagesOfTwoTimes_areNotPutTogether() {
    hear(UbxGolden.of("NAV-POSLLH", "NAV-VELNED"));
    hear(UbxGolden.changed("NAV-SOL", 0, 1, 2, 3, 4)); // another time of week

    assertThat(gps.latest()).isEmpty();
  }

  @Test
  void accept_sameMessagesTwice_makeOneFix() {
    hear(UbxGolden.of("NAV-POSLLH", "NAV-VELNED", "NAV-SOL"));
    GpsFix fix = fix();
    hear(UbxGolden.of("NAV-VELNED", "NAV-SOL"));

    assertThat(fix()).isSameAs(fix);
  }

  @Test
  void accept_noFix_isNotValid() {
    hear(UbxGolden.changed("NAV-PVT", 21, 0)); // gnssFixOK
    assertThat(fix().valid()).isFalse();
    hear(UbxGolden.changed("NAV-PVT", 20, 5)); // time only
    assertThat(fix().valid()).isFalse();
    assertThat(fix().satellites()).isEqualTo(11);
    hear(UbxGolden.of("NAV-PVT"));
    assertThat(fix().valid()).isTrue();
    hear(UbxGolden.of("NAV-POSLLH", "NAV-VELNED"));
    hear(UbxGolden.changed("NAV-SOL", 10, 1)); // dead reckoning only
    assertThat(fix().valid()).isFalse();
    assertThat(gps.refused()).isZero();
  }

  @Test
  void accept_fixIn2d_saysNothingOfTheHeight() {
    hear(UbxGolden.changed("NAV-PVT", 20, 2));

    assertThat(fix().valid()).isTrue();
    assertThat(fix().altitudeM()).isEmpty();
    assertThat(fix().upMps()).isEmpty();
    assertThat(fix().verticalSigmaM()).isEmpty();
  }

  @Test
  void accept_outOfRange_isRefused() {
    hear(UbxGolden.changed("NAV-PVT", 28, 0xFF, 0xFF, 0xFF, 0x7F)); // latitude 214.7 deg
    assertThat(gps.latest()).isEmpty();
    assertThat(gps.refused()).isEqualTo(1);
    assertThat(gps.lastRefusal())
        .isEqualTo("UBX message 0107: latitude 214.7483647 is outside -90.0…90.0");
    hear(UbxGolden.changed("NAV-POSLLH", 16, 0xFF, 0xFF, 0xFF, 0x7F)); // 2147 km high
    hear(UbxGolden.of("NAV-VELNED", "NAV-SOL"));
    assertThat(gps.refused()).isEqualTo(2);
    assertThat(gps.latest()).isEmpty();
  }

  @Test
  void accept_tooShort_isRefused() {
    hear(UbxFramer.frame(0x01, 0x02, new byte[27]));

    assertThat(gps.lastRefusal()).isEqualTo("UBX message 0102: payload of 27 bytes, expected 28");
  }

  @Test
  void accept_wrongChecksum_isRefusedAndTheNextTaken() {
    byte[] broken = UbxGolden.of("NAV-PVT");
    broken[40] ^= 4;
    hear(broken);
    assertThat(gps.latest()).isEmpty();
    assertThat(gps.refused()).isEqualTo(1);
    assertThat(gps.lastRefusal()).isEqualTo("UBX message 01-07: wrong checksum");
    hear(UbxGolden.of("NAV-PVT"));
    assertThat(fix().valid()).isTrue();
  }

  @Test
  void accept_cutOffByTheNext_nextIsTaken() {
    hear(Arrays.copyOf(UbxGolden.of("NAV-PVT"), 50));
    hear(UbxGolden.of("NAV-PVT"));
    assertThat(fix().latitudeDeg())
        .as("found in what was taken for the rest of the first")
        .isCloseTo(37.2295733, within(MM));
    assertThat(gps.refused()).isEqualTo(1);
  }

  @Test
  void accept_absurdLength_isNotWaitedFor() {
    hear(new byte[] {(byte) 0xB5, 0x62, 0x01, 0x07, (byte) 0xFF, (byte) 0xFF});
    hear(UbxGolden.of("NAV-PVT"));

    assertThat(fix().valid()).isTrue();
    assertThat(gps.lastRefusal()).isEqualTo("UBX message 01-07: 65535 bytes long");
  }

  @Test
  void accept_nmeaInBetween_isPassedOver() {
    hear("$GPTXT,01,01,02,u-blox ag - www.u-blox.com*50\r\n".getBytes(StandardCharsets.US_ASCII));
    hear(UbxGolden.of("NAV-PVT"));

    assertThat(fix().valid()).isTrue();
    assertThat(gps.refused()).isZero();
  }

  @Test
  void reset_halfAMessage_isForgotten() {
    byte[] message = UbxGolden.of("NAV-PVT");
    hear(Arrays.copyOf(message, 50));
    gps.reset();
    hear(Arrays.copyOfRange(message, 50, message.length));

    assertThat(gps.latest()).isEmpty();
    assertThat(gps.refused()).isZero();
  }
}
