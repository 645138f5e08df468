package org.u2sa.flightgear.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What counts as an answer, from servers that answer anything. */
@Timeout(60)
class PropertyServerTest {
  private interface Answer {
    void write(OutputStream out) throws IOException;
  }

  private static String get(Answer answer) throws IOException, InterruptedException {
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      Thread other = new Thread(() -> serve(server, answer));
      other.start();
      try (PropertyServer properties = new PropertyServer("127.0.0.1", server.getLocalPort())) {
        return properties.get("/sim/x");
      } finally {
        other.join();
      }
    }
  }

  private static void serve(ServerSocket server, Answer answer) {
    try (Socket socket = server.accept()) {
      answer.write(socket.getOutputStream());
      while (socket.getInputStream().read() >= 0) { // until the other side closes
        continue;
      }
    } catch (IOException e) {
      return; // the other side has had enough
    }
  }

  private static byte[] ascii(String text) {
    return text.getBytes(StandardCharsets.US_ASCII);
  }

  @Test
  void get_answerAmongOtherLines_isItsValue() throws Exception {
    assertThat(get(out -> out.write(ascii("hello\r\n/> /sim/x = '7' (double)\r\n"))))
        .isEqualTo("7");
  }

  @Test
  void get_lineThatNeverEnds_isRefusedAtItsLength() {
    assertThatThrownBy(
            () ->
                get(
                    out -> {
                      byte[] part = "x".repeat(10_000).getBytes(StandardCharsets.US_ASCII);
                      while (true) {
                        out.write(part);
                      }
                    }))
        .isInstanceOf(IOException.class)
        .hasMessage(
            "property server answered \"get /sim/x\" by a line of more than 4096 characters");
  }

  @Test
  void get_linesThatAreNoAnswer_areGivenUpAtTheirNumber() {
    assertThatThrownBy(() -> get(out -> out.write(ascii("no\n".repeat(100)))))
        .hasMessage("property server did not answer \"get /sim/x\"");
  }
}
