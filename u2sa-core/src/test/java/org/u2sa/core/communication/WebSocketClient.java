package org.u2sa.core.communication;

import java.io.ByteArrayOutputStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import javax.net.ssl.SSLContext;

/** A page's WebSocket, from which MQTT packets go and come. */
final class WebSocketClient implements WebSocket.Listener {
  private static final int PACKET_START = 4; // bytes of CONNACK

  private final ByteArrayOutputStream received = new ByteArrayOutputStream(); // guarded by itself
  final CompletableFuture<Void> ended = new CompletableFuture<>();
  private volatile boolean isDeaf;
  private WebSocket socket;

  /** Opens a WebSocket as a page of an origin. */
  static WebSocketClient open(String uri, String origin, SSLContext tls) {
    WebSocketClient client = new WebSocketClient();
    HttpClient.Builder http = HttpClient.newBuilder();
    if (tls != null) {
      http.sslContext(tls);
    }
    client.socket =
        http.build()
            .newWebSocketBuilder()
            .header("Origin", origin)
            .subprotocols("mqtt")
            .buildAsync(URI.create(uri), client)
            .orTimeout(20, TimeUnit.SECONDS)
            .join();
    return client;
  }

  /** Sends a packet in frames of this size. */
  void send(byte[] packet, int frameBytes) {
    for (int from = 0; from < packet.length; from += frameBytes) {
      byte[] part = Arrays.copyOfRange(packet, from, Math.min(packet.length, from + frameBytes));
      socket.sendBinary(ByteBuffer.wrap(part), true).join();
    }
  }

  void send(byte[] packet) {
    send(packet, packet.length);
  }

  /** Takes one more frame at most. */
  void stopReading() {
    isDeaf = true;
  }

  WebSocket socket() {
    return socket;
  }

  /** All bytes received, in hexadecimal. */
  String received() {
    synchronized (received) {
      return HexFormat.of().formatHex(received.toByteArray());
    }
  }

  /** Return code of CONNACK; -1 before. */
  int connectCode() {
    synchronized (received) {
      return received.size() < PACKET_START ? -1 : received.toByteArray()[PACKET_START - 1];
    }
  }

  @Override
  public CompletionStage<?> onBinary(WebSocket from, ByteBuffer data, boolean last) {
    synchronized (received) {
      while (data.hasRemaining()) {
        received.write(data.get());
      }
    }
    if (!isDeaf) {
      from.request(1);
    }
    return null;
  }

  @Override
  public CompletionStage<?> onClose(WebSocket from, int code, String reason) {
    ended.complete(null);
    return null;
  }

  @Override
  public void onError(WebSocket from, Throwable error) {
    ended.complete(null);
  }
}
