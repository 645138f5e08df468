package org.u2sa.core.communication;

import java.util.Map;
import org.u2sa.interfaces.XmlConfiguration;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.messages.MessageTypes;
import org.u2sa.testkit.FreePort;

/** MQTT through the embedded broker. */
class EmbeddedBrokerContractTest extends TransportContract {
  private final int port = FreePort.find();
  private final CommunicationManager manager =
      CommunicationManager.start(
          "cessna",
          XmlConfiguration.inMemory("test", Map.of("COMMUNICATION MANAGER PORT", port)),
          MessageTypes.standard(),
          line -> {
            throw new AssertionError(line);
          });

  @Override
  Transport transport() {
    return TestManager.transport(port);
  }

  @Override
  void close() {
    manager.close();
  }
}
