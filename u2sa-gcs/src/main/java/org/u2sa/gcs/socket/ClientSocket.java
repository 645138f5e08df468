package org.u2sa.gcs.socket;

import io.netty.buffer.Unpooled;
import io.netty.channel.Channel;
import io.netty.handler.codec.http.HttpHeaders;
import io.netty.handler.codec.http.websocketx.BinaryWebSocketFrame;
import io.netty.handler.codec.http.websocketx.CloseWebSocketFrame;
import io.netty.handler.codec.http.websocketx.TextWebSocketFrame;
import io.netty.handler.codec.http.websocketx.WebSocketCloseStatus;
import java.util.Optional;

/** The server's end of one client's WebSocket. Sending does not block. Thread-safe. */
public final class ClientSocket {
  private final Channel channel;
  private final HttpHeaders headers;
  private final String subprotocol;

  ClientSocket(Channel channel, HttpHeaders headers, String subprotocol) {
    this.channel = channel;
    this.headers = headers;
    this.subprotocol = subprotocol;
  }

  public String address() {
    return String.valueOf(channel.remoteAddress());
  }

  /** Header of the handshake request. */
  public Optional<String> header(String name) {
    return Optional.ofNullable(headers.get(name));
  }

  /** The agreed subprotocol; empty if none. */
  public String subprotocol() {
    return subprotocol == null ? "" : subprotocol;
  }

  public boolean isActive() {
    return channel.isActive();
  }

  /** Whether the client reads fast enough: its buffer has room. */
  public boolean isWritable() {
    return channel.isWritable();
  }

  /** Bytes that the client must read before {@link #isWritable} holds again. */
  public long backlog() {
    return channel.bytesBeforeWritable();
  }

  /** Sends a text. */
  public void text(String text) {
    channel.writeAndFlush(new TextWebSocketFrame(text));
  }

  /** Sends one binary message made of two parts, which must not be modified afterwards. */
  public void binary(byte[] head, byte[] data) {
    channel.writeAndFlush(new BinaryWebSocketFrame(Unpooled.wrappedBuffer(head, data)));
  }

  /** Disconnects. */
  public void close() {
    channel.close();
  }

  /** Disconnects because of a protocol violation, with a reason. */
  public void close(String why) {
    channel.writeAndFlush(new CloseWebSocketFrame(WebSocketCloseStatus.PROTOCOL_ERROR, why));
    channel.close();
  }
}
