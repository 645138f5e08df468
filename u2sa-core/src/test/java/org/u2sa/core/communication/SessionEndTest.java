package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.core.communication.limit.BrokerLimits;

/** How connections end, and what is left of them. */
class SessionEndTest {
  private static final String OWN = "u2sa/cessna/own/Tide";
  private static final byte[] DISCONNECT = {(byte) 0xe0, 0};
  private static final int WILL = 0x06; // with a clean session
  private static final int CONFIRMED = 0x08;
  private static final int RETAINED = 0x20;

  private final PacketPipeline first =
      new PacketPipeline(Map.of("MAX CLIENTS", 16, "MAX CLIENT RETAINED BYTES", 16_384));
  private final List<PacketPipeline> others = new ArrayList<>();

  @AfterEach
  void close() {
    others.forEach(PacketPipeline::close);
    first.close();
  }

  private PacketPipeline another() {
    PacketPipeline client = new PacketPipeline(first);
    others.add(client);
    return client;
  }

  private PacketPipeline withWill(int flags, byte[] will) {
    PacketPipeline client = another();
    client.send(MqttPacketBytes.connect("testator", WILL | flags, OWN, will));
    client.broker.clients.connected(client.session.connection());
    client.pass(2);
    client.taken();
    return client;
  }

  private void assertNothingLogged() {
    assertThat(first.log).isEmpty();
  }

  private void assertLogged(String start) {
    assertThat(first.log).anyMatch(line -> line.startsWith(start));
  }

  /** {"x": this number of bytes} */
  private static byte[] map(int bytes) {
    byte[] cbor = new byte[6 + bytes];
    cbor[0] = (byte) 0xa1;
    cbor[1] = 0x61;
    cbor[2] = 'x';
    cbor[3] = 0x59;
    cbor[4] = (byte) (bytes >> 8);
    cbor[5] = (byte) bytes;
    return cbor;
  }

  @Test
  void look_saysNothingForTenSeconds_isPutOut() {
    first.passSeconds(10);
    assertThat(first.channel.isOpen()).isTrue();
    first.passSeconds(1);

    assertThat(first.channel.isOpen()).isFalse();
    assertLogged(
        "connection closed: the client did not identify itself: user \"anonymous\", "
            + "client \"\"");
  }

  @Test
  void look_hasSaidWhoItIs_stays() {
    first.introduced();
    first.passSeconds(60);
    assertThat(first.channel.isOpen()).isTrue();
    assertNothingLogged();
  }

  @Test
  void channelRead_firstPacketIsNoConnect_isMalformed() {
    first.send(MqttPacketBytes.PINGREQ);
    assertThat(first.channel.isOpen()).isFalse();
    assertLogged("malformed packet: user \"anonymous\", client \"\", from 127.0.0.1, the first");
  }

  @Test
  void channelRead_afterGoodbye_nothingIsDone() {
    first.introduced();
    first.send(MqttPacketBytes.subscribe("u2sa/#"));
    first.sent();
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    bytes.writeBytes(DISCONNECT);
    bytes.writeBytes(MqttPacketBytes.publish(OWN, 1, 1));
    first.send(bytes.toByteArray());

    assertThat(first.taken()).containsExactly("DISCONNECT");
    assertThat(first.sent()).isEmpty();
  }

  @Test
  void channelRead_onlyWhatBypassesMoquette_doesNotWakeIt() {
    first.introduced();
    int[] complete = new int[1];
    first
        .channel
        .pipeline()
        .addLast(
            new ChannelInboundHandlerAdapter() {
              @Override
              public void channelReadComplete(ChannelHandlerContext ctx) {
                complete[0]++;
              }
            });
    first.send(MqttPacketBytes.publish(OWN, 1));
    first.send(MqttPacketBytes.PINGREQ);
    assertThat(complete[0]).isZero();
    first.send(DISCONNECT);
    assertThat(complete[0]).isEqualTo(1);
  }

  @Test
  void exceptionCaught_connectionLost_isNoRefusalAndTheWillReportsIt() {
    first.introduced();
    first.send(MqttPacketBytes.subscribe("u2sa/#"));
    first.sent();
    PacketPipeline client = withWill(0, map(1));
    client.channel.pipeline().fireExceptionCaught(new IOException("Connection reset"));
    first.pass(1);

    assertThat(client.channel.isOpen()).isFalse();
    assertNothingLogged();
    assertThat(first.sent()).hasSize(1);
  }

  @Test
  void exceptionCaught_anotherFault_isLogged() {
    first.introduced();
    first.channel.pipeline().fireExceptionCaught(new IllegalStateException("odd"));
    assertThat(first.channel.isOpen()).isFalse();
    assertLogged(
        "connection failed: user \"anonymous\", client \"client\", from 127.0.0.1, \"odd\"");
  }

  @Test
  void exceptionCaught_strangerLost_isLogged() {
    first.channel.pipeline().fireExceptionCaught(new IOException("Connection reset"));
    assertThat(first.channel.isOpen()).isFalse();
    assertLogged("connection failed");
  }

  @Test
  void channelInactive_willOfQualityOne_countsAsKept() {
    withWill(0, map(10)).close();
    assertThat(first.broker.kept()).isZero();
    withWill(CONFIRMED, map(10)).close();
    assertThat(first.broker.kept()).isEqualTo(16);
  }

  @Test
  void channelInactive_noRoomToRetainTheWill_isLoggedAndPresentOnesHearIt() {
    first.introduced();
    first.send(MqttPacketBytes.subscribe("u2sa/#"));
    first.sent();
    PacketPipeline client = withWill(CONFIRMED | RETAINED, map(600));
    for (int i = 0; i < 40; i++) {
      client.send(
          MqttPacketBytes.retained(OWN + i, "\u00a1\u0061x\u0059\u0002\u0000" + "\0".repeat(512)));
    }
    first.sentPackets();
    client.close();
    first.pass(1);

    assertLogged("will refused, too many retained bytes of one client");
    assertThat(first.sentPackets()).isEqualTo(1);
  }

  @Test
  void handlerRemoved_moreClientsThanAllowedOneAfterAnother_eachIsAdmitted() {
    for (int i = 0; i < 40; i++) {
      PacketPipeline client = another();
      client.send(MqttPacketBytes.connect("client" + i, 0));
      assertThat(client.taken()).contains("CONNECT");
      client.close();
    }
  }

  @Test
  void handlerRemoved_subscriber_nobodyListensAnyMore() {
    first.introduced();
    PacketPipeline client = another().introduced("other");
    client.send(MqttPacketBytes.subscribe("u2sa/#"));
    assertThat(first.broker.subscriptions.route(OWN).isWanted()).isTrue();
    client.close();
    assertThat(first.broker.subscriptions.route(OWN).isWanted()).isFalse();
  }

  @Test
  void handlerAdded_tooManyWhoSayNothing_theOldestGoesForANewerOne() {
    List<PacketPipeline> strangers = new ArrayList<>();
    for (int i = 0; i < BrokerLimits.PENDING_PER_ADDRESS - 1; i++) {
      strangers.add(another()); // with the first one as many as allowed
    }
    strangers.get(5).close();
    strangers.get(6).send(MqttPacketBytes.connect("client", 0));
    another();
    another();
    first.pass(1);
    assertThat(first.channel.isOpen()).isTrue();

    another();
    first.pass(1);
    assertThat(first.channel.isOpen()).isFalse();
    assertLogged("pending connection closed in favour of a newer one");
  }
}
