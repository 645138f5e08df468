package org.u2sa.sim.sensor;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class UartTransmitterTest {
  private static final int BAUD = 10_000; // a byte a millisecond
  private final UartTransmitter line = new UartTransmitter(BAUD, 10);
  private final byte[] buffer = new byte[64];

  @Test
  void take_bytesOnTheWay_arriveOneByOne() {
    line.send(500, bytes("abc"));
    assertThat(taken(1_499)).isEmpty();
    assertThat(taken(1_500)).isEqualTo("a");
    assertThat(taken(3_500)).isEqualTo("bc");
  }

  @Test
  void take_secondMessage_waitsForTheFirst() {
    line.send(0, bytes("ab"));
    line.send(1_000, bytes("c"));
    assertThat(taken(2_000)).isEqualTo("ab");
    assertThat(taken(2_999)).isEmpty();
    assertThat(taken(3_000)).isEqualTo("c");
  }

  @Test
  void take_messageAfterAPauseNobodyAskedIn_isNotEarly() {
    line.send(0, bytes("ab"));
    line.send(50_000, bytes("c"));
    assertThat(taken(50_999)).isEqualTo("ab");
    assertThat(taken(51_000)).isEqualTo("c");
  }

  @Test
  void send_bufferFull_dropsTheWholeMessage() {
    line.send(0, bytes("12345678"));
    line.send(0, bytes("abc"));
    line.send(0, bytes("de"));
    assertThat(taken(100_000)).isEqualTo("12345678de");
    assertThat(line.dropped()).isEqualTo(1);
  }

  @Test
  void take_listenerAtAnotherRate_understandsNothing() {
    line.send(0, bytes("abc"));
    assertThat(line.take(100_000, 9_600, buffer)).isZero();
    assertThat(taken(200_000)).isEmpty();
  }

  @Test
  void forget_bytesNobodyListenedTo_areGone() {
    line.send(0, bytes("abc"));
    line.forget(2_500);
    assertThat(taken(100_000)).isEqualTo("c");
  }

  private String taken(long micros) {
    int count = line.take(micros, BAUD, buffer);
    return new String(buffer, 0, count, StandardCharsets.US_ASCII);
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.US_ASCII);
  }
}
