package org.u2sa.core.communication.web;

import static org.assertj.core.api.Assertions.assertThat;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.embedded.EmbeddedChannel;
import io.netty.handler.codec.http.HttpRequest;
import io.netty.handler.codec.http.HttpServerCodec;
import io.netty.util.ReferenceCountUtil;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.core.communication.limit.WorkQueue;

/** What of a client's bytes is decoded and answered, and when. */
class WebInputTest {
  private static final int MANY = 1_000;
  private static final String HOST = "Host: 127.0.0.1\r\n";
  private static final String REQUEST = "GET /a.js HTTP/1.1\r\n" + HOST + "\r\n";

  private final WebSite site =
      () -> Map.of("/a.js", new WebSite.File("text/javascript", "let a;".getBytes()));
  private final Session session = new Session();
  private long nowMicros;
  private long decodingMicros;
  private int decoded; // number of requests
  private final WorkQueue turns = new WorkQueue(() -> nowMicros);
  private final EmbeddedChannel channel = channel();

  private static final class Session implements WebSession {
    private boolean isPending = true;
    private String why = "";

    @Override
    public boolean isPending() {
      return isPending;
    }

    @Override
    public boolean isOut() {
      return !why.isEmpty();
    }

    @Override
    public void putOut(String reason) {
      why = reason;
    }
  }

  private final class Counter extends ChannelInboundHandlerAdapter {
    @Override
    public void channelRead(ChannelHandlerContext ctx, Object message) {
      decoded += message instanceof HttpRequest ? 1 : 0;
      nowMicros += decodingMicros;
      ctx.fireChannelRead(message);
    }
  }

  private EmbeddedChannel channel() {
    WebConnection connection =
        new WebConnection(
            new WebResponses(site),
            SameOrigin.of(false, InetAddress.getLoopbackAddress()),
            session);
    EmbeddedChannel built =
        new EmbeddedChannel(
            new WebInput(turns, connection, session),
            new HttpServerCodec(),
            new Counter(),
            connection);
    built.freezeTime();
    return built;
  }

  @AfterEach
  void close() {
    channel.finishAndReleaseAll();
  }

  private void send(String text) {
    channel.writeInbound(Unpooled.copiedBuffer(text, StandardCharsets.US_ASCII));
  }

  private void pass(int milliseconds) {
    nowMicros += 1_000L * milliseconds;
    channel.advanceTimeBy(milliseconds, TimeUnit.MILLISECONDS);
    channel.runScheduledPendingTasks();
  }

  private String answers() {
    StringBuilder text = new StringBuilder();
    for (ByteBuf part = channel.readOutbound(); part != null; part = channel.readOutbound()) {
      text.append(part.toString(StandardCharsets.US_ASCII));
      part.release();
    }
    return text.toString();
  }

  @Test
  void channelRead_requestsThatDoNotWait_oneIsDecodedAndNoneAnswered() {
    send(REQUEST.repeat(MANY));

    assertThat(decoded).isEqualTo(1);
    assertThat(answers()).isEmpty();
    assertThat(session.why).isEqualTo(WebConnection.NOT_AWAITED);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "HEAD / HTTP/1.0\r\n\r\n",
        "GET /b.js HTTP/1.1\r\n" + HOST + "\r\n",
        "POST / HTTP/1.1\r\n" + HOST + "\r\n",
        "GET /mqtt HTTP/1.1\r\n" + HOST + "Upgrade: websocket\r\n\r\n",
        "G\r\n\r\n",
        "G\n\n"
      })
  void channelRead_requestsThatAreRefused_atMostTheFirstIsAnsweredAndTheConnectionEnds(
      String request) {
    send(request.repeat(MANY));

    assertThat(decoded).isEqualTo(1);
    assertThat(answers().split("HTTP/1.1 4", -1)).hasSizeLessThanOrEqualTo(2);
    assertThat(session.isOut() || !channel.isOpen()).isTrue();
  }

  @Test
  void channelRead_nextRequestAfterTheAnswer_isAnswered() {
    for (int i = 0; i < 3; i++) {
      send("\r\n" + REQUEST);
      assertThat(answers()).startsWith("HTTP/1.1 200 OK\r\n").endsWith("let a;");
    }
    assertThat(session.isOut()).isFalse();
  }

  @Test
  void channelRead_requestByteByByte_isAnswered() {
    REQUEST.chars().forEach(letter -> send(String.valueOf((char) letter)));

    assertThat(answers()).startsWith("HTTP/1.1 200 OK\r\n");
  }

  @Test
  void channelRead_requestWithABody_isRefusedWithoutIt() {
    send("POST / HTTP/1.1\r\n" + HOST + "Expect: 100-continue\r\nContent-Length: 99\r\n\r\nbody");

    assertThat(answers()).startsWith("HTTP/1.1 405 ");
    assertThat(channel.isOpen()).isFalse();
    assertThat(session.isOut()).isFalse();
  }

  @Test
  void channelRead_requestThatDoesNotEnd_isRefused() {
    send("GET /a.js HTTP/1.1\r\nX: " + "y".repeat(WebInput.LONGEST_REQUEST));

    assertThat(answers()).startsWith("HTTP/1.1 400 ");
    assertThat(channel.isOpen()).isFalse();
  }

  @Test
  void channelRead_othersTookTheTime_waitsForItsTurn() {
    decodingMicros = 50_000;
    send(REQUEST);
    assertThat(answers()).startsWith("HTTP/1.1 200 OK\r\n");
    decodingMicros = 0;

    send(REQUEST);
    assertThat(answers()).isEmpty();
    pass(200);
    assertThat(answers()).isEmpty();
    pass(400);
    assertThat(answers()).startsWith("HTTP/1.1 200 OK\r\n");
  }

  @Test
  void channelRead_anotherRequestBeforeTheTurnOfTheFirst_endsTheConnection() {
    decodingMicros = 50_000;
    send(REQUEST);
    send(REQUEST);
    assertThat(session.isOut()).isFalse();

    send(REQUEST);
    assertThat(session.why).isEqualTo(WebConnection.NOT_AWAITED);
    pass(600);
    assertThat(decoded).isEqualTo(1);
  }

  @Test
  void channelRead_framesBeforeTheLogIn_waitForTheirTurnAndKeepTheirOrder() {
    decodingMicros = 50_000;
    send(REQUEST);
    channel.pipeline().remove(HttpServerCodec.class);
    channel.pipeline().remove(Counter.class);
    channel.pipeline().remove(WebConnection.class);

    send("first ");
    session.isPending = false; // logged in meanwhile
    send("second");
    Object early = channel.readInbound();
    assertThat(early).isNull();
    pass(600);
    assertThat(inbound()).isEqualTo("first second");
    send("third");
    assertThat(inbound()).isEqualTo("third");
  }

  private String inbound() {
    StringBuilder text = new StringBuilder();
    for (ByteBuf part = channel.readInbound(); part != null; part = channel.readInbound()) {
      text.append(part.toString(StandardCharsets.US_ASCII));
      ReferenceCountUtil.release(part);
    }
    return text.toString();
  }
}
