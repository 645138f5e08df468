package org.u2sa.flightgear.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Whoever listens at the property server's port. */
@Timeout(60)
final class PropertyServerTest {
  private ServerSocket listener;

  @BeforeEach
  void open() throws IOException {
    listener = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"));
  }

  @AfterEach
  void close() throws IOException {
    listener.close();
  }

  /** Answers the first request with a text, again and again until the client leaves. */
  private void answer(String text, boolean endlessly) {
    Thread thread =
        new Thread(
            () -> {
              try (Socket client = listener.accept()) {
                InputStream in = client.getInputStream();
                OutputStream out = client.getOutputStream();
                in.read();
                do {
                  out.write(text.getBytes(StandardCharsets.ISO_8859_1));
                } while (endlessly);
                in.read(new byte[1_024]);
                in.read(); // until the client closes
              } catch (IOException e) {
                return; // the client has left
              }
            });
    thread.setDaemon(true);
    thread.start();
  }

  private PropertyServer server() throws IOException {
    return new PropertyServer("127.0.0.1", listener.getLocalPort());
  }

  @Test
  void get_answer_isItsValue() throws IOException {
    answer("/sim/version = '2020.3' (string)\r\n/> ", false);
    try (PropertyServer server = server()) {
      assertThat(server.get("/sim/version")).isEqualTo("2020.3");
    }
  }

  @Test
  void get_lineThatNeverEnds_isRefusedAtItsLimit() throws IOException {
    answer("x".repeat(1_000), true);
    try (PropertyServer server = server()) {
      assertThatThrownBy(() -> server.get("/sim/version"))
          .isInstanceOf(IOException.class)
          .hasMessage("property server: \"get /sim/version\" has an answer longer than 4096 bytes");
    }
  }

  @Test
  void get_linesOfOtherThings_areNoAnswer() throws IOException {
    answer("nothing\r\n", true);
    try (PropertyServer server = server()) {
      assertThatThrownBy(() -> server.get("/sim/version"))
          .hasMessage("property server did not answer \"get /sim/version\"");
    }
  }
}
