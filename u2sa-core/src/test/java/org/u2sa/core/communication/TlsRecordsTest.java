package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.embedded.EmbeddedChannel;
import io.netty.handler.ssl.SslContextBuilder;
import io.netty.handler.ssl.SslHandler;
import java.nio.file.Path;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.SSLException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.core.security.SecurityDirectory;

/** How much decryption a client can ask for without sending any data. */
class TlsRecordsTest {
  private static final int MANY = 1_000;

  @TempDir static Path folder;
  private static SecurityDirectory authority;

  private final PacketPipeline broker = new PacketPipeline();
  private EmbeddedChannel client;
  private SslHandler clients;
  private int decrypted; // records

  @BeforeAll
  static void makeAuthority() throws Exception {
    authority = TestAuthority.in(folder);
  }

  @AfterEach
  void close() {
    client.finishAndReleaseAll();
    broker.close();
  }

  private void connect(String protocol) throws Exception {
    TlsRecords records = new TlsRecords(broker.broker, broker.session);
    broker.channel.pipeline().addFirst(records, new Counter(), brokers(), records.behind());
    SSLEngine engine = TestAuthority.trusting(authority).createSSLEngine();
    engine.setUseClientMode(true);
    engine.setEnabledProtocols(new String[] {protocol});
    clients = new SslHandler(engine);
    client = new EmbeddedChannel(clients);
    exchange();
    assertThat(clients.handshakeFuture().isSuccess()).isTrue();
    say(MqttPacketBytes.connect("client", 0));
    broker.broker.clients.connected(broker.session.connection());
    broker.pass(2);
    exchange();
    decrypted = 0;
  }

  private static SslHandler brokers() throws SSLException {
    SSLEngine engine =
        SslContextBuilder.forServer(authority.certificate().toFile(), authority.key().toFile())
            .build()
            .newEngine(Unpooled.EMPTY_BUFFER.alloc());
    return new SslHandler(engine);
  }

  private final class Counter extends ChannelInboundHandlerAdapter {
    @Override
    public void channelRead(ChannelHandlerContext ctx, Object message) {
      decrypted++;
      ctx.fireChannelRead(message);
    }
  }

  /** Carries what both sides have written, until none has anything left. */
  private void exchange() {
    boolean any = true;
    while (any && broker.channel.isOpen()) {
      any = false;
      for (ByteBuf part = client.readOutbound(); part != null; part = client.readOutbound()) {
        any = true;
        arrive(part);
      }
      for (ByteBuf part = broker.channel.readOutbound();
          part != null;
          part = broker.channel.readOutbound()) {
        any = true;
        client.writeInbound(part);
      }
    }
  }

  private void arrive(ByteBuf bytes) {
    if (broker.channel.isOpen()) {
      broker.channel.writeInbound(bytes);
      broker.channel.runPendingTasks();
    } else {
      bytes.release();
    }
  }

  private void say(byte[] packet) {
    client.writeOutbound(Unpooled.wrappedBuffer(packet));
    exchange();
  }

  private boolean isPutOut(String why) {
    return !broker.channel.isOpen() && broker.log.stream().anyMatch(line -> line.startsWith(why));
  }

  @Test
  void keyUpdates_withoutEnd_arePutOutAfterFew() throws Exception {
    connect("TLSv1.3");
    for (int i = 0; i < MANY; i++) {
      clients.renegotiate();
      exchange();
    }
    assertThat(isPutOut("connection closed, too many TLS records without data")).isTrue();
    assertThat(decrypted).isLessThanOrEqualTo(TlsRecords.WITHOUT_DATA_AT_ONCE + 1);
  }

  @Test
  void keyUpdates_inOnePiece_areNotDecryptedBeyondFew() throws Exception {
    connect("TLSv1.3");
    ByteBuf all = Unpooled.buffer();
    for (int i = 0; i < MANY; i++) {
      clients.renegotiate();
      for (ByteBuf part = client.readOutbound(); part != null; part = client.readOutbound()) {
        all.writeBytes(part);
        part.release();
      }
    }
    arrive(all);
    assertThat(isPutOut("connection closed, too many TLS records without data")).isTrue();
    assertThat(decrypted).isLessThanOrEqualTo(TlsRecords.WITHOUT_DATA_AT_ONCE + 1);
  }

  @Test
  void keyUpdates_nowAndThen_areNormal() throws Exception {
    connect("TLSv1.3");
    for (int i = 0; i < 200; i++) {
      clients.renegotiate();
      exchange();
      broker.pass(10_000);
      say(MqttPacketBytes.PINGREQ);
    }
    assertThat(broker.channel.isOpen()).isTrue();
  }

  @Test
  void secondHandshake_ofTls12_isRefused() throws Exception {
    connect("TLSv1.2");
    clients.renegotiate();
    exchange();
    assertThat(isPutOut("connection closed, it started a second TLS handshake")).isTrue();
    assertThat(decrypted).isZero();
  }

  @ParameterizedTest
  @ValueSource(strings = {"TLSv1.2", "TLSv1.3"})
  void records_withData_areNotLimited(String protocol) throws Exception {
    connect(protocol);
    for (int i = 0; i < MANY; i++) {
      say(MqttPacketBytes.PINGREQ);
    }
    assertThat(broker.channel.isOpen()).isTrue();
    assertThat(decrypted).isEqualTo(MANY);
  }
}
