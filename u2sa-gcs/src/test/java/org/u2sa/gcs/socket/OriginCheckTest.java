package org.u2sa.gcs.socket;

import static org.assertj.core.api.Assertions.assertThat;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.embedded.EmbeddedChannel;
import io.netty.handler.codec.http.DefaultFullHttpRequest;
import io.netty.handler.codec.http.FullHttpRequest;
import io.netty.handler.codec.http.FullHttpResponse;
import io.netty.handler.codec.http.HttpHeaderNames;
import io.netty.handler.codec.http.HttpMethod;
import io.netty.handler.codec.http.HttpObjectAggregator;
import io.netty.handler.codec.http.HttpServerCodec;
import io.netty.handler.codec.http.HttpVersion;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whose web pages may look at a vehicle. */
class OriginCheckTest {
  /** Whether the handshake passes; null: without the header. */
  private static boolean passes(String origin, String... allowed) {
    EmbeddedChannel channel = new EmbeddedChannel(new OriginCheck(Set.of(allowed)));
    FullHttpRequest request = new DefaultFullHttpRequest(HttpVersion.HTTP_1_1, HttpMethod.GET, "/");
    if (origin != null) {
      request.headers().set(HttpHeaderNames.ORIGIN, origin);
    }
    boolean passed = channel.writeInbound(request);
    if (!passed) {
      FullHttpResponse answer = channel.readOutbound();
      assertThat(answer.status().code()).isEqualTo(403);
      assertThat(channel.isOpen()).isFalse();
    }
    channel.finishAndReleaseAll();
    return passed;
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "http://localhost:8080",
        "http://127.0.0.1",
        "https://[::1]:3000",
        "https://app.foxglove.dev",
        "file://"
      })
  void channelRead_viewersPage_passes(String origin) {
    assertThat(passes(origin)).isTrue();
  }

  @Test
  void channelRead_noBrowser_passes() {
    assertThat(passes(null)).isTrue();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "https://evil.example",
        "null",
        "https://localhost.evil.example",
        "https://localhost@evil.example",
        "https://app.foxglove.dev.evil.example",
        "http://app.foxglove.dev",
        "%",
        ""
      })
  void channelRead_otherPage_isRefused(String origin) {
    assertThat(passes(origin)).isFalse();
  }

  @ParameterizedTest
  @ValueSource(strings = {"https://evil.example", "http://localhost"})
  void channelRead_manyRequestsAtOnce_onlyTheFirstIsAnsweredOrPasses(String origin) {
    EmbeddedChannel channel =
        new EmbeddedChannel(
            new HttpServerCodec(), new HttpObjectAggregator(1_024), new OriginCheck(Set.of()));
    String request = "GET / HTTP/1.1\r\nOrigin: " + origin + "\r\n\r\n";
    channel.writeInbound(Unpooled.copiedBuffer(request.repeat(100), StandardCharsets.US_ASCII));

    String answers = "";
    for (ByteBuf part = channel.readOutbound(); part != null; part = channel.readOutbound()) {
      answers += part.toString(StandardCharsets.US_ASCII);
      part.release();
    }
    assertThat(channel.inboundMessages().size() + answers.split("HTTP/1.1 403", -1).length - 1)
        .isEqualTo(1);
    assertThat(channel.isOpen()).isFalse();
    channel.finishAndReleaseAll();
  }

  @Test
  void channelRead_pageThatWasNamed_passes() {
    assertThat(passes("https://viewer.example", "https://viewer.example")).isTrue();
    assertThat(passes("https://viewer.example:8080", "https://viewer.example")).isFalse();
    assertThat(passes("null", "*")).isTrue();
  }
}
