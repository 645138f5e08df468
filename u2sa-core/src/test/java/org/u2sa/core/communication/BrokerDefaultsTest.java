package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.Socket;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What a broker of which nobody has configured anything offers to the network: nothing. */
@Timeout(60)
class BrokerDefaultsTest {
  /** 127.0.0.2 is this host too, as 0.0.0.0 would answer on it. */
  private static List<InetAddress> otherAddresses() throws IOException {
    List<InetAddress> others = new ArrayList<>(List.of(InetAddress.getByName("127.0.0.2")));
    for (NetworkInterface each : Collections.list(NetworkInterface.getNetworkInterfaces())) {
      Collections.list(each.getInetAddresses()).stream()
          .filter(address -> !address.isLoopbackAddress())
          .forEach(others::add);
    }
    return others;
  }

  @Test
  void start_withoutAWordOfConfiguration_isReachedOnLoopbackOnly() throws IOException {
    try (TestManager broker = new TestManager()) {
      assertThat(broker.manager().address().orElseThrow().getAddress().getHostAddress())
          .isEqualTo("127.0.0.1");
      try (Socket socket = new Socket()) {
        socket.connect(new InetSocketAddress("127.0.0.1", broker.port));
      }
      for (InetAddress other : otherAddresses()) {
        try (Socket socket = new Socket()) {
          assertThatThrownBy(() -> socket.connect(new InetSocketAddress(other, broker.port)))
              .as(other.toString())
              .isInstanceOf(ConnectException.class);
        }
      }
    }
  }
}
