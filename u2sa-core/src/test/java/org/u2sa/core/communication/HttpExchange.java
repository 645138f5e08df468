package org.u2sa.core.communication;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;

/** Sends HTTP requests as no browser would, and reads what comes until the server closes. */
final class HttpExchange {
  private HttpExchange() {}

  /** The answer to one request with some header lines; a header Connection: close is added. */
  static String answer(int port, String requestLine, String... headers) throws IOException {
    String all = String.join("\r\n", headers);
    return raw(new Socket(), port, requestLine + "\r\nConnection: close\r\n" + all + "\r\n\r\n");
  }

  /** The answer of a server by TLS to a request for the page. */
  static String page(Socket unconnected, int port) throws IOException {
    return raw(
        unconnected,
        port,
        "GET / HTTP/1.1\r\nHost: localhost:" + port + "\r\nConnection: close\r\n\r\n");
  }

  private static String raw(Socket unconnected, int port, String text) throws IOException {
    try (Socket socket = unconnected) {
      socket.setSoTimeout(20_000);
      socket.connect(new InetSocketAddress("127.0.0.1", port));
      socket.getOutputStream().write(text.getBytes(StandardCharsets.US_ASCII));
      socket.getOutputStream().flush();
      return new String(socket.getInputStream().readAllBytes(), StandardCharsets.ISO_8859_1);
    }
  }
}
