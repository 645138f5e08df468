package org.u2sa.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import org.junit.jupiter.api.Test;

class TakenPortTest {
  @Test
  void replacement_takenAndFreePort_isAnotherOrNone() throws IOException {
    int port;
    try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))) {
      port = taken.getLocalPort();
      assertThat(TakenPort.replacement("127.0.0.1", port)).isPresent().isNotEqualTo(port);
    }
    assertThat(TakenPort.replacement("127.0.0.1", port)).isEmpty();
  }
}
