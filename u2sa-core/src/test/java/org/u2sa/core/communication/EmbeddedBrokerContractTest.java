package org.u2sa.core.communication;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.Map;
import org.u2sa.interfaces.XmlConfiguration;
import org.u2sa.interfaces.communication.MqttTransport;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.messages.MessageCodec;
import org.u2sa.messages.MessageTypes;

class EmbeddedBrokerContractTest extends TransportContract {
  private final int port = freePort();
  private final CommunicationManager manager =
      CommunicationManager.start(
          "cessna",
          XmlConfiguration.inMemory("test", Map.of("COMMUNICATION MANAGER PORT", port)),
          MessageTypes.standard(),
          line -> {
            throw new AssertionError(line);
          });

  private static int freePort() {
    try (ServerSocket probe = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return probe.getLocalPort();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  Transport transport() {
    return new MqttTransport(
        "127.0.0.1", port, "cessna", new MessageCodec(MessageTypes.standard()));
  }

  @Override
  void close() {
    manager.close();
  }
}
