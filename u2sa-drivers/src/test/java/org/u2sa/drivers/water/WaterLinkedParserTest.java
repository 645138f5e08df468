package org.u2sa.drivers.water;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.device.port.VelocityLog;

/** The examples of Water Linked's own protocol page, and what is wrong with others. */
class WaterLinkedParserTest {
  private final WaterLinkedParser parser = new WaterLinkedParser();

  private VelocityLog.Speeds say(String lines) {
    byte[] bytes = lines.getBytes(US_ASCII);
    parser.accept(bytes, bytes.length, 7);
    return parser.latest().orElseThrow();
  }

  @Test
  void accept_exampleOfProtocol2_isForwardLeftDown() {
    VelocityLog.Speeds speeds =
        say(
            "wrz,0.120,-0.400,2.000,y,1.30,1.855,1e-07;0;1.4;0;1.2;0;0.2;0;1e+09,7,14,123.00,1*50\n");
    assertThat(speeds.groundX()).hasValue(0.12);
    assertThat(speeds.groundY()).hasValue(0.4);
    assertThat(speeds.groundZ()).hasValue(2.0);
    assertThat(speeds.waterX()).isEmpty();
    assertThat(speeds.measuredAtMicros()).isEqualTo(7);
  }

  @Test
  void accept_exampleOfTheOlderProtocol_isRead() {
    VelocityLog.Speeds speeds = say("wrx,112.83,0.007,0.017,0.006,0.000,0.93,y,0*d2\r\n");
    assertThat(speeds.groundX()).hasValue(0.007);
    assertThat(speeds.groundY()).hasValue(-0.017);
  }

  @Test
  void accept_exampleWithoutLock_saysNothing() {
    assertThat(say("wrx,1075.51,0.000,0.000,0.000,2.707,-1.00,n,1*04\n").isAny()).isFalse();
    assertThat(parser.refused()).isZero();
  }

  @Test
  void accept_otherLines_arePassedOver() {
    say("wrx,112.83,0.007,0.017,0.006,0.000,0.93,y,0*d2\nwru,0,0.070,1.10,-40,-95*9c\nwra*xx\n");
    assertThat(parser.refused()).isZero();
  }

  @Test
  void accept_wrongChecksum_isRefused() {
    say(
        "wrx,112.83,0.007,0.017,0.006,0.000,0.93,y,0*d2\nwrx,112.83,0.008,0.017,0.006,0,1,y,0*d2\n");
    assertThat(parser.refused()).isEqualTo(1);
    assertThat(parser.lastRefusal()).startsWith("missing or wrong checksum: wrx,112.83,0.008");
  }
}
