package org.u2sa.drivers.motor;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigInteger;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** The bytes of RoboClaw's packet serial protocol. */
class RoboClawRequestTest {
  private static byte[] hex(String text) {
    byte[] bytes = new BigInteger("01" + text.replace(" ", ""), 16).toByteArray();
    return Arrays.copyOfRange(bytes, 1, bytes.length);
  }

  @Test
  void crc_knownVectors_agree() {
    byte[] check = "123456789".getBytes(US_ASCII);
    assertThat(RoboClawRequest.crc(0, check, 0, check.length))
        .as("CRC-16/XMODEM's check")
        .isEqualTo(0x31C3);
    // A whole packet in the tests of github.com/dumbotics/roboclaw_serial: set velocity PID of M1.
    byte[] packet = hex("80 1c 00000000 000021b7 0000036e 0003135a");
    assertThat(RoboClawRequest.crc(0, packet, 0, packet.length)).isEqualTo(0x7D8E);
  }

  @Test
  void packet_duty_isSignedBigEndianWithCrc() {
    assertThat(RoboClawRequest.duty(100.0, -50.0).packet(0x80))
        .startsWith(hex("80 22 7fff c001"))
        .hasSize(8);
    byte[] packet = RoboClawRequest.duty(100.0, -50.0).packet(0x80);
    assertThat(RoboClawRequest.crc(0, packet, 0, packet.length))
        .as("over all with its CRC")
        .isZero();
  }

  @Test
  void packet_questions_areTwoBytes() {
    assertThat(RoboClawRequest.encoders().packet(0x87)).isEqualTo(hex("87 4e"));
    assertThat(RoboClawRequest.battery().packet(0x80)).isEqualTo(hex("80 18"));
  }

  @Test
  void packet_serialTimeout_isRoundedUpToTenths() {
    assertThat(RoboClawRequest.serialTimeout(0.3).packet(0x80)).startsWith(hex("80 0e 03"));
    assertThat(RoboClawRequest.serialTimeout(0.31).packet(0x80)).startsWith(hex("80 0e 04"));
    assertThat(RoboClawRequest.serialTimeout(25.5).packet(0x80)).startsWith(hex("80 0e ff"));
  }

  @Test
  void isAnsweredBy_anyBitTurned_isRefused() {
    byte[] data = hex("000030f0 ffffcfdc 0000");
    int crc = RoboClawRequest.crc(RoboClawRequest.crc(0, hex("80 4e"), 0, 2), data, 0, 8);
    data[8] = (byte) (crc >> 8);
    data[9] = (byte) crc;
    assertThat(RoboClawRequest.encoders().isAnsweredBy(0x80, data, 10)).isTrue();
    assertThat(RoboClawRequest.signed32(data, 4)).isEqualTo(-12324);
    for (int bit = 0; bit < 80; bit++) {
      byte[] turned = data.clone();
      turned[bit / 8] ^= (byte) (1 << bit % 8);
      assertThat(RoboClawRequest.encoders().isAnsweredBy(0x80, turned, 10)).isFalse();
    }
    assertThat(RoboClawRequest.encoders().isAnsweredBy(0x80, data, 9)).isFalse();
    assertThat(RoboClawRequest.encoders().isAnsweredBy(0x81, data, 10)).as("another's").isFalse();
  }
}
