package org.u2sa.gcs.view;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayOutputStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/** A viewer made of the JDK's WebSocket client. */
final class Viewer implements WebSocket.Listener, AutoCloseable {
  private static final int WAIT_S = 30;

  /** A message that came under a subscription. */
  record Data(long subscription, long nanos, byte[] bytes) {}

  final BlockingQueue<JsonNode> texts = new LinkedBlockingQueue<>();
  final BlockingQueue<Data> data = new LinkedBlockingQueue<>();
  final BlockingQueue<Long> times = new LinkedBlockingQueue<>();
  final BlockingQueue<String> closed = new LinkedBlockingQueue<>();
  private final ObjectMapper json = new ObjectMapper();
  private final StringBuilder text = new StringBuilder();
  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
  private final WebSocket socket;

  Viewer(int port, String subprotocol) {
    socket =
        HttpClient.newHttpClient()
            .newWebSocketBuilder()
            .subprotocols(subprotocol)
            .buildAsync(URI.create("ws://127.0.0.1:" + port + "/"), this)
            .join();
  }

  String subprotocol() {
    return socket.getSubprotocol();
  }

  void send(String message) {
    socket.sendText(message.replace('\'', '"'), true).join();
  }

  void sendBytes(byte[] message) {
    socket.sendBinary(ByteBuffer.wrap(message), true).join();
  }

  /** The next text with that operation; others are skipped. */
  JsonNode next(String operation) throws InterruptedException {
    while (true) {
      JsonNode next = texts.poll(WAIT_S, TimeUnit.SECONDS);
      if (next == null || next.get("op").asText().equals(operation)) {
        return next;
      }
    }
  }

  Data nextData() throws InterruptedException {
    return data.poll(WAIT_S, TimeUnit.SECONDS);
  }

  @Override
  public CompletionStage<?> onText(WebSocket from, CharSequence part, boolean last) {
    text.append(part);
    if (last) {
      try {
        texts.add(json.readTree(text.toString()));
      } catch (java.io.IOException e) {
        throw new IllegalStateException(text.toString(), e);
      }
      text.setLength(0);
    }
    from.request(1);
    return null;
  }

  @Override
  public CompletionStage<?> onBinary(WebSocket from, ByteBuffer part, boolean last) {
    byte[] piece = new byte[part.remaining()];
    part.get(piece);
    bytes.writeBytes(piece);
    if (last) {
      ByteBuffer frame = ByteBuffer.wrap(bytes.toByteArray()).order(ByteOrder.LITTLE_ENDIAN);
      bytes.reset();
      if (frame.get() == 1) {
        long subscription = Integer.toUnsignedLong(frame.getInt());
        long nanos = frame.getLong();
        byte[] payload = new byte[frame.remaining()];
        frame.get(payload);
        data.add(new Data(subscription, nanos, payload));
      } else {
        times.add(frame.getLong());
      }
    }
    from.request(1);
    return null;
  }

  @Override
  public CompletionStage<?> onClose(WebSocket from, int status, String reason) {
    closed.add(status + " " + reason);
    return null;
  }

  @Override
  public void close() {
    socket.abort();
  }
}
