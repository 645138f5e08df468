package org.u2sa.core.communication;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import java.util.regex.Pattern;

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

  /** Number of answers to some text, until the server ends the connection. */
  static int answers(int port, String text) throws IOException {
    StringBuilder all = new StringBuilder();
    try (Socket socket = new Socket("127.0.0.1", port)) {
      socket.setSoTimeout(20_000);
      socket.getOutputStream().write(text.getBytes(StandardCharsets.US_ASCII));
      byte[] part = new byte[65_536];
      for (int n = 0; n >= 0; n = socket.getInputStream().read(part)) {
        all.append(new String(part, 0, n, StandardCharsets.ISO_8859_1));
      }
    } catch (SocketException e) { // it ends without having read everything
      return answers(all);
    }
    return answers(all);
  }

  private static int answers(CharSequence received) {
    return (int) Pattern.compile("HTTP/1.1 ").matcher(received).results().count();
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
