package org.u2sa.gcs.socket;

import io.netty.channel.ChannelFutureListener;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.handler.codec.http.DefaultFullHttpResponse;
import io.netty.handler.codec.http.HttpHeaderNames;
import io.netty.handler.codec.http.HttpRequest;
import io.netty.handler.codec.http.HttpResponseStatus;
import io.netty.handler.codec.http.HttpVersion;
import io.netty.util.ReferenceCountUtil;
import java.net.URI;
import java.util.Set;

/**
 * Rejects web pages other than viewers: a browser lets any page connect to this host, and
 * identifies it in the Origin header (RFC 6455, section 10.2). Programs other than browsers send
 * none. Only a connection's first request is answered, because the next one is no handshake either.
 */
final class OriginCheck extends ChannelInboundHandlerAdapter {
  private static final Set<String> USUAL = Set.of("https://app.foxglove.dev", "file://");
  private static final Set<String> THIS_HOST = Set.of("localhost", "127.0.0.1", "[::1]");

  private final Set<String> others;
  private boolean isAsked; // a request has come

  /** Accepts these origins in addition to the default ones and this host's; "*" for all. */
  OriginCheck(Set<String> others) {
    this.others = others;
  }

  @Override
  public void channelRead(ChannelHandlerContext context, Object message) {
    if (!(message instanceof HttpRequest request)) {
      context.fireChannelRead(message);
      return;
    }
    if (isAsked) {
      ReferenceCountUtil.release(message);
      context.close();
      return;
    }
    isAsked = true;
    String origin = request.headers().get(HttpHeaderNames.ORIGIN);
    if (origin == null || isAllowed(origin)) {
      context.fireChannelRead(message);
      return;
    }
    ReferenceCountUtil.release(message);
    context
        .writeAndFlush(
            new DefaultFullHttpResponse(HttpVersion.HTTP_1_1, HttpResponseStatus.FORBIDDEN))
        .addListener(ChannelFutureListener.CLOSE);
  }

  private boolean isAllowed(String origin) {
    return USUAL.contains(origin)
        || others.contains(origin)
        || others.contains("*")
        || isOfThisHost(origin);
  }

  private static boolean isOfThisHost(String origin) {
    try {
      String host = URI.create(origin).getHost();
      return host != null && THIS_HOST.contains(host);
    } catch (IllegalArgumentException e) {
      return false; // not sent by a browser
    }
  }
}
