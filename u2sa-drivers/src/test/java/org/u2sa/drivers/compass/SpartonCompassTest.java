package org.u2sa.drivers.compass;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.drivers.nmea.Nmea;

/** Bytes are those of Sparton's Software Interface User's Manual, legacy protocol. */
class SpartonCompassTest {
  private static final double TINY = 1e-9;

  private final SpartonCompass compass = new SpartonCompass();

  private void hear(int... octets) {
    for (int octet : octets) {
      compass.accept(new byte[] {(byte) octet}, 1, 5_000);
    }
  }

  private double headingDeg() {
    return Math.toDegrees(compass.latest().orElseThrow().headingRad());
  }

  @Test
  void request_asksForTheMagneticHeading() {
    assertThat(SpartonCompass.request()).containsExactly((byte) 0xA4, (byte) 0x09, (byte) 0xA0);
  }

  @Test
  void accept_magneticHeading_isTaken() {
    hear(0xA4, 0x09, 0x04, 0x00, 0xA0); // 1024 of 4096

    assertThat(headingDeg()).isCloseTo(90.0, within(TINY));
    assertThat(compass.latest().orElseThrow().isTrue()).isFalse();
    assertThat(compass.latest().orElseThrow().measuredAtMicros()).isEqualTo(5_000);
  }

  @Test
  void accept_trueHeading_isTaken() {
    hear(0xA4, 0x02, 0x0F, 0xFF, 0xA0);

    assertThat(headingDeg()).isCloseTo(4095 * 360.0 / 4096, within(TINY));
    assertThat(compass.latest().orElseThrow().isTrue()).isTrue();
  }

  @Test
  void accept_dataThatLookLikeTheProtocol_isNotTakenForIt() {
    hear(0xA4, 0x09, 0x09, 0xA4, 0xA0);

    assertThat(headingDeg()).isCloseTo(0x09A4 * 360.0 / 4096, within(TINY));
    assertThat(compass.refused()).isZero();
  }

  @Test
  void accept_headingOfATurnOrMore_isRefused() {
    hear(0xA4, 0x09, 0x10, 0x00, 0xA0);

    assertThat(compass.latest()).isEmpty();
    assertThat(compass.lastRefusal()).isEqualTo("a heading of 4096 of 4096: A4 09 10 00 A0");
  }

  @Test
  void accept_cutOffByTheNext_nextIsTaken() {
    hear(0xA4, 0x09, 0x04);
    hear(0xA4, 0x09, 0x04, 0x00, 0xA0);

    assertThat(headingDeg()).isCloseTo(90.0, within(TINY));
    assertThat(compass.refused()).isEqualTo(1);
  }

  @Test
  void accept_errorAnswer_isRefusedAndTheNextTaken() {
    hear(0xA4, 0xAE, 0xA0, 0xA4, 0x09, 0x08, 0x00, 0xA0);

    assertThat(headingDeg()).isCloseTo(180.0, within(TINY));
    assertThat(compass.lastRefusal()).isEqualTo("an unrequested answer: A4 AE");
  }

  @Test
  void accept_sentences_areTakenToo() {
    hear(0xA4, 0x09, 0x04, 0x00, 0xA0);
    byte[] sentence = Nmea.bytes("HCHDM,12.0,M");
    compass.accept(sentence, sentence.length, 6_000);
    assertThat(headingDeg()).isCloseTo(12.0, within(TINY));
    hear(0xA4, 0x09, 0x08, 0x00, 0xA0);
    assertThat(headingDeg()).isCloseTo(180.0, within(TINY));
  }

  @Test
  void reset_halfAnAnswer_isForgotten() {
    hear(0xA4, 0x09, 0x04);
    compass.reset();
    hear(0xA4, 0x09, 0x08, 0x00, 0xA0);

    assertThat(headingDeg()).isCloseTo(180.0, within(TINY));
    assertThat(compass.refused()).isZero();
  }
}
