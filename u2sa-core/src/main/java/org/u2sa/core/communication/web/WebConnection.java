package org.u2sa.core.communication.web;

import io.netty.channel.ChannelFutureListener;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.handler.codec.http.FullHttpRequest;
import io.netty.handler.codec.http.FullHttpResponse;
import io.netty.handler.codec.http.HttpHeaderNames;
import io.netty.handler.codec.http.HttpHeaderValues;
import io.netty.handler.codec.http.HttpMethod;
import io.netty.handler.codec.http.HttpRequest;
import io.netty.handler.codec.http.HttpResponseStatus;
import io.netty.handler.codec.http.HttpUtil;
import io.netty.handler.codec.http.websocketx.BinaryWebSocketFrame;
import io.netty.handler.codec.http.websocketx.CloseWebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketFrame;
import io.netty.util.ReferenceCountUtil;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/**
 * One connection to the operator's page: serves files until the page opens its MQTT WebSocket, and
 * then passes on only what MQTT needs. Confined to its connection's thread.
 */
public final class WebConnection extends ChannelInboundHandlerAdapter {
  /** Path of the WebSocket. */
  public static final String MQTT_PATH = "/mqtt";

  /** Longest WebSocket frame [bytes]; an MQTT packet may span several. */
  public static final int LONGEST_FRAME = 16 * 1_024;

  /** Timeout; shorter than the broker's for connections that do not log in. */
  private static final long FILES_WITHIN_MS = 8_000;

  private static final Set<HttpMethod> READING = Set.of(HttpMethod.GET, HttpMethod.HEAD);

  private final WebResponses responses;
  private final SameOrigin origin;
  private final Consumer<String> putOut;
  private boolean isAnswering; // a response has not been sent completely
  private boolean isUpgraded;
  private ScheduledFuture<?> end;

  /**
   * @param putOut ends the connection, and logs why
   */
  public WebConnection(WebResponses responses, SameOrigin origin, Consumer<String> putOut) {
    this.responses = responses;
    this.origin = origin;
    this.putOut = putOut;
  }

  @Override
  public void handlerAdded(ChannelHandlerContext ctx) {
    end = ctx.executor().schedule(() -> ctx.close(), FILES_WITHIN_MS, TimeUnit.MILLISECONDS);
  }

  @Override
  public void handlerRemoved(ChannelHandlerContext ctx) {
    end.cancel(false);
  }

  @Override
  public void channelRead(ChannelHandlerContext ctx, Object message) {
    if (message instanceof WebSocketFrame frame) {
      frame(ctx, frame);
    } else if (message instanceof FullHttpRequest request && isUpgrade(request)) {
      isUpgraded = true;
      end.cancel(false);
      ctx.fireChannelRead(message);
    } else {
      try {
        answer(ctx, message);
      } finally {
        ReferenceCountUtil.release(message);
      }
    }
  }

  /**
   * Rejects fragments, texts and pings, because they would cost unbounded memory or answers. A page
   * in a browser cannot send pings, and this one sends no fragments or texts.
   */
  private void frame(ChannelHandlerContext ctx, WebSocketFrame frame) {
    boolean isMqtt = frame instanceof BinaryWebSocketFrame && frame.isFinalFragment();
    if (isMqtt || frame instanceof CloseWebSocketFrame) {
      ctx.fireChannelRead(frame);
    } else {
      frame.release();
      putOut.accept("connection closed, WebSocket frame is not binary or is incomplete");
    }
  }

  private boolean isUpgrade(FullHttpRequest request) {
    return !isUpgraded
        && !isAnswering
        && request.decoderResult().isSuccess()
        && request.uri().equals(MQTT_PATH)
        && request.method().equals(HttpMethod.GET)
        && request
            .headers()
            .containsValue(HttpHeaderNames.UPGRADE, HttpHeaderValues.WEBSOCKET, true)
        && origin.isHost(request.headers())
        && origin.isOwnPage(request.headers());
  }

  private void answer(ChannelHandlerContext ctx, Object message) {
    if (isAnswering || isUpgraded || !(message instanceof HttpRequest request)) {
      putOut.accept("connection closed, HTTP requests sent without waiting for the answers");
      return;
    }
    isAnswering = true;
    boolean isKeepAlive = HttpUtil.isKeepAlive(request);
    Optional<HttpResponseStatus> refusal = refusal(request);
    if (refusal.isPresent()) {
      send(ctx, WebResponses.error(refusal.get()), isKeepAlive);
    } else {
      responses.answer(request, request.uri(), response -> pass(ctx, response, isKeepAlive));
    }
  }

  /** Sends a response that may come from another thread. */
  private void pass(ChannelHandlerContext ctx, FullHttpResponse response, boolean isKeepAlive) {
    if (ctx.executor().inEventLoop()) {
      send(ctx, response, isKeepAlive);
      return;
    }
    try {
      ctx.executor().execute(() -> send(ctx, response, isKeepAlive));
    } catch (RejectedExecutionException e) { // the broker has ended, and the connection with it
      responses.sent(response.status(), response.content().readableBytes());
    }
  }

  private void send(ChannelHandlerContext ctx, FullHttpResponse response, boolean isKeepAlive) {
    boolean isKept =
        isKeepAlive && response.status().code() < HttpResponseStatus.BAD_REQUEST.code();
    HttpUtil.setKeepAlive(response, isKept);
    int bytes = response.content().readableBytes();
    ctx.writeAndFlush(response)
        .addListener(
            done -> {
              isAnswering = false;
              responses.sent(response.status(), bytes);
              if (!isKept) {
                ctx.close();
              }
            })
        .addListener(ChannelFutureListener.CLOSE_ON_FAILURE);
  }

  private Optional<HttpResponseStatus> refusal(HttpRequest request) {
    if (request.decoderResult().isFailure()) {
      return Optional.of(HttpResponseStatus.BAD_REQUEST);
    }
    if (!origin.isHost(request.headers())) {
      return Optional.of(HttpResponseStatus.MISDIRECTED_REQUEST);
    }
    if (!READING.contains(request.method())) {
      return Optional.of(HttpResponseStatus.METHOD_NOT_ALLOWED);
    }
    return request.uri().equals(MQTT_PATH)
        ? Optional.of(HttpResponseStatus.FORBIDDEN) // another page, or no WebSocket
        : Optional.empty();
  }
}
