package org.u2sa.core.communication;

import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.mqtt.MqttClient;

/** MQTT through the embedded broker, by Paho. */
class EmbeddedBrokerPahoContractTest extends EmbeddedBrokerContractTest {
  @Override
  Transport transport() {
    return TestManager.transport(port()).by(MqttClient.PAHO);
  }
}
