package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelOutboundHandlerAdapter;
import io.netty.channel.ChannelPromise;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What still arrives of a client that is out, and how soon its connection ends. */
class ReceivedBytesTest {
  private final PacketPipeline client = new PacketPipeline().introduced();

  @AfterEach
  void close() {
    client.close();
  }

  @Test
  void channelRead_afterDisconnect_isNotDecoded() {
    client.send(MqttPacketBytes.packet(0xe0, new byte[0]));
    client.decoded.clear();
    client.send(MqttPacketBytes.PINGREQ);
    assertThat(client.decoded).isEmpty();
  }

  @Test
  void putOutFor_encryptionThatWaitsForItsClient_closesAtOnce() {
    client
        .channel
        .pipeline()
        .addAfter(
            client.channel.pipeline().firstContext().name(),
            "waiting",
            new ChannelOutboundHandlerAdapter() {
              @Override
              public void close(ChannelHandlerContext ctx, ChannelPromise promise) {
                // as SslHandler does until its goodbye was read
              }
            });
    client.session.putOutFor("test");
    client.channel.runPendingTasks();
    assertThat(client.channel.isOpen()).isFalse();
  }
}
