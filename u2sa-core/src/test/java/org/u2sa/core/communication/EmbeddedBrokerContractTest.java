package org.u2sa.core.communication;

import java.util.Map;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.mqtt.MqttClient;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.testkit.FreePort;

/** MQTT through the embedded broker, by our own client. */
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

  int port() {
    return port;
  }

  @Override
  Transport transport() {
    return TestManager.transport(port).by(MqttClient.DIRECT);
  }

  @Override
  void close() {
    manager.close();
  }
}
