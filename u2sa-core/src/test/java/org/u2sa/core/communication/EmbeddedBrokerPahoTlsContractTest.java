package org.u2sa.core.communication;

import org.u2sa.interfaces.mqtt.MqttClient;

/** MQTT through the embedded broker, encrypted, by Paho. */
class EmbeddedBrokerPahoTlsContractTest extends EmbeddedBrokerTlsContractTest {
  @Override
  MqttClient client() {
    return MqttClient.PAHO;
  }
}
