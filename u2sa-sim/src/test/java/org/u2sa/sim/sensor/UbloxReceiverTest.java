package org.u2sa.sim.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;

class UbloxReceiverTest {
  private static final VehicleTruth STANDING =
      new VehicleTruth(
          0.0,
          Point.of(0, 0, 0),
          new Attitude(0.0, 0.0, 0),
          Point.of(0, 0, 0),
          Point.ORIGIN,
          Point.ORIGIN);
  private static final byte[] SET_RATE_5_HZ = {
    (byte) 0xB5, 0x62, 0x06, 0x08, 6, 0, (byte) 200, 0, 1, 0, 1, 0, (byte) 0xDE, 0x6A
  }; // as u-center sends it
  private static final byte[] ACK_RATE = {
    (byte) 0xB5, 0x62, 0x05, 0x01, 2, 0, 0x06, 0x08, 0x16, 0x3F
  };

  private final UbloxReceiver receiver = receiver(UbloxSettings.factory());
  private final StringBuilder heard = new StringBuilder();
  private long nowUs;

  private static UbloxReceiver receiver(UbloxSettings settings) {
    LocalPlane plane = new LocalPlane(new Geodetic(8.0, 47.0, 400.0));
    UtcTime utc = new UtcTime(Instant.parse("2026-06-01T12:00:00Z"));
    return new UbloxReceiver(settings, GpsParameters.survey(), plane, utc, new NoiseStreams(1L));
  }

  @Test
  void advance_fromTheFactory_sendsFourSentencesASecond() {
    run(10.0, receiver.line().baud());
    assertThat(count("$GPGGA,")).isEqualTo(10);
    assertThat(count("$GPRMC,")).isEqualTo(10);
    assertThat(count("$GPVTG,")).isEqualTo(10);
    assertThat(count("$GPGST,")).isBetween(9L, 10L); // the last may be on its way
    assertThat(heard).contains("$GPGGA,120003.00,4700.0000");
  }

  @Test
  void advance_firstByte_comesAfterTheLatencyAndAByteTime() {
    run(0.061, 9_600);
    assertThat(heard).isEmpty();
    run(0.004, 9_600);
    assertThat(heard.toString()).startsWith("$"); // after 60 ms and 1.04 ms
  }

  @Test
  void accept_rateOf5Hz_isAcknowledgedAndObeyed() {
    receiver.accept(0, 9_600, SET_RATE_5_HZ, SET_RATE_5_HZ.length);
    run(0.02, 9_600);
    assertThat(heard.toString()).isEqualTo(latin(ACK_RATE));
    heard.setLength(0);
    UbloxReceiver fast = receiver(UbloxSettings.binary(115_200, 1.0));
    fast.accept(0, 115_200, SET_RATE_5_HZ, SET_RATE_5_HZ.length);
    run(fast, 10.1, 115_200);
    assertThat(count(latin(new byte[] {(byte) 0xB5, 0x62, 0x01, 0x02}))).isEqualTo(50);
  }

  @Test
  void accept_messagesSwitched_changesWhatIsSent() {
    byte[] off = ubx(0x06, 0x01, 0xF0, 0x05, 0); // VTG
    byte[] on = ubx(0x06, 0x01, 0x01, 0x07, 0, 1, 0, 0, 0, 0); // PVT, six ports
    receiver.accept(0, 9_600, off, off.length);
    receiver.accept(0, 9_600, on, on.length);
    run(3.0, 9_600);
    assertThat(count("$GPVTG")).isZero();
    assertThat(count(latin(new byte[] {(byte) 0xB5, 0x62, 0x01, 0x07, 92, 0}))).isEqualTo(3);
  }

  @Test
  void accept_portAtAnotherRate_answersAtTheOldOneAndGoesOnAtTheNew() {
    byte[] port =
        ubx(0x06, 0x00, 1, 0, 0, 0, 0xD0, 8, 0, 0, 0x00, 0x96, 0, 0, 3, 0, 2, 0, 0, 0, 0, 0);
    receiver.accept(0, 9_600, port, port.length);
    run(0.02, 9_600);
    assertThat(heard.toString()).isEqualTo(latin(ubx(0x05, 0x01, 0x06, 0x00)));
    heard.setLength(0);
    byte[] pvt = ubx(0x06, 0x01, 0x01, 0x07, 1); // but the port is to send NMEA alone
    receiver.accept(nowUs, 38_400, pvt, pvt.length);
    run(2.0, 38_400);
    assertThat(count("$GPGGA")).isEqualTo(2);
    assertThat(count(latin(new byte[] {(byte) 0xB5, 0x62}))).isZero();
  }

  @Test
  void accept_whatItDoesNotKnow_isRefusedAndGarbageIgnored() {
    byte[] unknown = ubx(0x06, 0x8A, 1, 2, 3, 4);
    byte[] broken = ubx(0x06, 0x08, 200, 0, 1, 0, 1, 0);
    broken[7] ^= 1;
    byte[] tooLong = {(byte) 0xB5, 0x62, 0x06, 0x08, (byte) 0xFF, (byte) 0xFF};
    byte[] half = {(byte) 0xB5, (byte) 0xB5, 0x62};
    for (byte[] bytes : new byte[][] {tooLong, broken, {0, 1, 2}, unknown}) {
      receiver.accept(0, 9_600, bytes, bytes.length);
    }
    receiver.accept(0, 9_600, half, half.length);
    receiver.accept(0, 9_600, Arrays.copyOfRange(SET_RATE_5_HZ, 2, 14), 12);
    run(0.03, 9_600);
    assertThat(heard.toString()).isEqualTo(latin(ubx(0x05, 0x00, 0x06, 0x8A)) + latin(ACK_RATE));
  }

  @Test
  void advance_moreThanTheLineCarries_dropsWholeMessagesOnly() {
    UbloxReceiver flooded =
        receiver(new UbloxSettings(9_600, 10.0, UbloxSettings.factory().messages(), 7));
    run(flooded, 20.0, 9_600);
    assertThat(flooded.line().dropped()).isPositive();
    String[] lines = heard.toString().split("\r\n");
    for (int i = 0; i < lines.length - 1; i++) {
      assertThat(lines[i]).matches("\\$GP[A-Z]{3},.*\\*[0-9A-F]{2}");
    }
  }

  @Test
  void binary_moreThanTheLineCarries_isRefused() {
    assertThat(UbloxSettings.binary(9_600, 9.0).rateHz()).isEqualTo(9.0);
    assertThatThrownBy(() -> UbloxSettings.binary(9_600, 10.0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("baud: 9600 carries less than 10.0 positions of 104 bytes per second");
  }

  private static byte[] ubx(int messageClass, int id, int... payload) {
    UbxMessage message = new UbxMessage(messageClass, id, payload.length);
    for (int octet : payload) {
      message.u1(octet);
    }
    return message.bytes();
  }

  private void run(double seconds, int baud) {
    run(receiver, seconds, baud);
  }

  private void run(UbloxReceiver which, double seconds, int baud) {
    long end = nowUs + Math.round(seconds * 1e6);
    while (nowUs < end) {
      step(which, baud);
    }
  }

  private void step(UbloxReceiver which, int baud) {
    which.advance(nowUs, STANDING, false);
    byte[] buffer = new byte[256];
    int length = which.line().take(nowUs, baud, buffer);
    heard.append(latin(Arrays.copyOf(buffer, length)));
    nowUs += 2_000;
  }

  private long count(String what) {
    return heard.toString().split(java.util.regex.Pattern.quote(what), -1).length - 1L;
  }

  private static String latin(byte[] bytes) {
    return new String(bytes, StandardCharsets.ISO_8859_1);
  }
}
