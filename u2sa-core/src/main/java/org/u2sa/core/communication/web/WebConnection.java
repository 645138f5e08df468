package org.u2sa.core.communication.web;

import io.netty.channel.ChannelFutureListener;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
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

/**
 * One connection to the operator's page: serves files until the page opens its MQTT WebSocket, and
 * then passes on only what MQTT needs. Confined to its connection's thread.
 */
public final class WebConnection extends ChannelInboundHandlerAdapter {
  /** Path of the WebSocket. */
  public static final String MQTT_PATH = "/mqtt";

  /** Longest WebSocket frame [bytes]; an MQTT packet may span several. */
  public static final int LONGEST_FRAME = 16 * 1_024;

  /** Reason to end a connection. */
  static final String NOT_AWAITED =
      "connection closed, HTTP requests sent without waiting for the answers";

  /** Timeout; shorter than the broker's for connections that do not log in. */
  private static final long FILES_WITHIN_MS = 8_000;

  private static final Set<HttpMethod> READING = Set.of(HttpMethod.GET, HttpMethod.HEAD);

  private final WebResponses responses;
  private final SameOrigin origin;
  private final WebSession session;
  private boolean isFollowed; // more bytes came with the request
  private boolean isAnswering; // a response has not been sent completely
  private boolean isUpgraded;
  private ScheduledFuture<?> end;

  /** Creates the handler of a new connection. */
  public WebConnection(WebResponses responses, SameOrigin origin, WebSession session) {
    this.responses = responses;
    this.origin = origin;
    this.session = session;
  }

  /** Whether a request has not been answered completely, or was the last one. */
  boolean isBusy() {
    return isAnswering || isUpgraded;
  }

  /**
   * Announces a request.
   *
   * @param followed whether the client sent more with it, which is not passed on
   */
  void expect(boolean followed) {
    isFollowed = followed;
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
    } else if (message instanceof HttpRequest request) {
      request(ctx, request);
    } else if (isUpgraded) {
      ctx.fireChannelRead(message); // end of the upgrade's request
    } else {
      ReferenceCountUtil.release(message);
    }
  }

  private void request(ChannelHandlerContext ctx, HttpRequest request) {
    if (isUpgrade(request)) {
      isUpgraded = true;
      end.cancel(false);
      ctx.fireChannelRead(request);
      return;
    }
    try {
      answer(ctx, request);
    } finally {
      ReferenceCountUtil.release(request);
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
      session.putOut("connection closed, WebSocket frame is not binary or is incomplete");
    }
  }

  private boolean isUpgrade(HttpRequest request) {
    return !isBusy()
        && !isFollowed
        && request.decoderResult().isSuccess()
        && request.uri().equals(MQTT_PATH)
        && request.method().equals(HttpMethod.GET)
        && request
            .headers()
            .containsValue(HttpHeaderNames.UPGRADE, HttpHeaderValues.WEBSOCKET, true)
        && origin.isHost(request.headers())
        && origin.isOwnPage(request.headers());
  }

  private void answer(ChannelHandlerContext ctx, HttpRequest request) {
    Optional<HttpResponseStatus> refusal = refusal(request);
    if (isBusy() || isFollowed && refusal.isEmpty()) {
      session.putOut(NOT_AWAITED);
      return;
    }
    isAnswering = true;
    boolean isKeepAlive = HttpUtil.isKeepAlive(request);
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
