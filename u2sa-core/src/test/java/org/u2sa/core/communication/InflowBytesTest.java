package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.core.communication.limit.BrokerLimits;

/** How many bytes a client is read, and how many answers it may leave unread. */
class InflowBytesTest {
  private static final int BYTES_PER_S = 1_000_000;
  private static final int BURST = BYTES_PER_S / 4;

  private final PacketPipeline pipeline =
      new PacketPipeline(Map.of("CLIENT BYTES PER SECOND", BYTES_PER_S)).introduced();

  @AfterEach
  void close() {
    pipeline.close();
  }

  private boolean isRead() {
    return pipeline.channel.config().isAutoRead();
  }

  /** Each byte counts, also of a packet that is no message and of one that is never complete. */
  @Test
  void channelRead_moreBytesThanTheRate_areReadAsFastAsItAllows() {
    pipeline.pass(1_000);
    byte[] half = new byte[BURST];
    half[0] = 0x30;
    half[1] = (byte) 0xff;
    half[2] = (byte) 0xff;
    half[3] = 0x3f;
    pipeline.send(half);
    assertThat(isRead()).isFalse();
    pipeline.pass(2);
    assertThat(isRead()).isTrue();

    pipeline.send(new byte[BYTES_PER_S / 10]);
    assertThat(isRead()).isFalse();
    pipeline.pass(90);
    assertThat(isRead()).isFalse();
    pipeline.pass(10);
    assertThat(isRead()).isTrue();
    assertThat(pipeline.decoded).isEmpty();
  }

  @Test
  void channelRead_subscriberIsBehind_aTenthOfTheBytes() {
    pipeline.pass(1_000);
    pipeline.inflow.subscriberIsBehind(true);
    pipeline.send(MqttPacketBytes.packet(0x30, new byte[(int) BrokerLimits.BEHIND_BYTES + 10_000]));
    assertThat(isRead()).isFalse();
    pipeline.pass(80);
    assertThat(isRead()).isFalse();
    pipeline.pass(40);
    assertThat(isRead()).isTrue();
  }

  @Test
  void received_lessThanTheRate_neverWaits() {
    for (int i = 0; i < 1_000; i++) {
      pipeline.inflow.received(BYTES_PER_S / 1_000);
      assertThat(isRead()).isTrue();
      pipeline.pass(1);
    }
  }

  @Test
  void channelRead_answersAreNotRead_theClientIsReadNoFurtherUntilTheyAre() {
    pipeline.pass(1_000);
    pipeline.readNothing();
    for (int i = 1; i <= 2_000; i++) {
      pipeline.send(MqttPacketBytes.publish(PacketPipeline.TOPIC, 1, i));
    }
    assertThat(isRead()).isFalse();
    pipeline.pass(1_000);
    assertThat(isRead()).isFalse();

    assertThat(pipeline.read()).isEqualTo(513);
    pipeline.pass(2);
    assertThat(isRead()).isTrue();
  }
}
