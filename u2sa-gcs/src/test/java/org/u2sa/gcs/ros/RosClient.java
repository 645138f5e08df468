package org.u2sa.gcs.ros;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.UnaryOperator;

/** A rosbridge client made of the JDK's WebSocket client. */
final class RosClient implements WebSocket.Listener, AutoCloseable {
  private static final int WAIT_S = 30;

  final BlockingQueue<JsonNode> texts = new LinkedBlockingQueue<>();
  final BlockingQueue<String> closed = new LinkedBlockingQueue<>();
  private final ObjectMapper json = new ObjectMapper();
  private final StringBuilder text = new StringBuilder();
  private final WebSocket socket;

  RosClient(int port) {
    this(port, builder -> builder);
  }

  RosClient(int port, UnaryOperator<WebSocket.Builder> headers) {
    socket =
        headers
            .apply(HttpClient.newHttpClient().newWebSocketBuilder())
            .buildAsync(URI.create("ws://127.0.0.1:" + port + "/"), this)
            .join();
  }

  void send(String message) {
    socket.sendText(message.replace('\'', '"'), true).join();
  }

  /** Sends more than the server takes: it may close before all has been sent. */
  void flood(String message) {
    socket.sendText(message.replace('\'', '"'), true).exceptionally(closed -> socket).join();
  }

  void sendBytes(byte[] message) {
    socket.sendBinary(ByteBuffer.wrap(message), true).join();
  }

  /** The next text with that operation; others are skipped. Null if none comes. */
  JsonNode next(String operation) throws InterruptedException {
    while (true) {
      JsonNode next = texts.poll(WAIT_S, TimeUnit.SECONDS);
      if (next == null || next.get("op").asText().equals(operation)) {
        return next;
      }
    }
  }

  String nextStatus() throws InterruptedException {
    return next("status").get("msg").asText();
  }

  /** Values of a service's answer, or the text of its refusal. */
  JsonNode call(String service, String arguments) throws InterruptedException {
    send("{'op':'call_service','id':'c','service':'" + service + "','args':" + arguments + "}");
    return next("service_response").get("values");
  }

  boolean isClosed() throws InterruptedException {
    return closed.poll(WAIT_S, TimeUnit.SECONDS) != null;
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
  public CompletionStage<?> onClose(WebSocket from, int status, String reason) {
    closed.add(status + " " + reason);
    return null;
  }

  @Override
  public void onError(WebSocket from, Throwable error) {
    closed.add(error.toString());
  }

  @Override
  public void close() {
    socket.abort();
  }
}
