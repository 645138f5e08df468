package org.u2sa.core.communication;

import java.util.Map;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.testkit.FreePort;

/** MQTT through the embedded broker. */
class EmbeddedBrokerContractTest extends TransportContract {
  private final int port = FreePort.find();
  private final CommunicationManager manager =
      CommunicationManager.start(
          "cessna",
          XmlConfiguration.inMemory("test", Map.of("COMMUNICATION MANAGER PORT", port)),
          StandardTypes.registry(),
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
