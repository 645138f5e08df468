package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.core.communication.limit.BrokerLimits;

/** Clients that send nothing but PINGREQ, each of which demands an answer. */
class PingFloodTest {
  private static final byte PINGREQ = (byte) 0xc0;
  private static final String PINGRESP = "d0";
  private static final int PER_SECOND = (int) BrokerLimits.PINGS_PER_SECOND;

  private final PacketPipeline client = new PacketPipeline().introduced();

  @AfterEach
  void close() {
    client.close();
  }

  private void ping(int times) {
    byte[] packets = new byte[2 * times];
    for (int i = 0; i < times; i++) {
      packets[2 * i] = PINGREQ;
    }
    client.send(packets);
  }

  @Test
  void pings_asOftenAsAKeepAlive_areAnsweredAtOnce() {
    client.sent();
    for (int second = 0; second < 20; second++) {
      ping(1);
      assertThat(client.sent()).containsExactly(PINGRESP);
      client.pass(1_000);
    }
  }

  @Test
  void pings_aWholeRead_aFewAreAnsweredAndTheRestWaits() {
    client.sentPackets();
    ping(BrokerLimits.READ_AT_ONCE / 2);

    assertThat(client.channel.config().isAutoRead()).isFalse();
    assertThat(client.sent()).hasSizeLessThanOrEqualTo(PER_SECOND);
    client.pass(1_000);
    assertThat(client.sent()).hasSizeBetween(1, PER_SECOND + 1);
    assertThat(client.channel.config().isAutoRead()).isFalse();
  }

  @Test
  void pings_fewerThanThatHaveWaited_othersAreReadAgain() {
    client.sent();
    ping(3 * PER_SECOND);
    client.passSeconds(3);

    assertThat(client.sent()).hasSize(3 * PER_SECOND);
    assertThat(client.channel.config().isAutoRead()).isTrue();
    assertThat(client.taken()).as("Moquette would flush each answer by itself").isEmpty();
  }
}
