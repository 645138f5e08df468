package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.ScheduledThreadPoolExecutor;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.time.SystemClock;

/** Which client speaks MQTT. */
class MqttClientTest {
  private static final String PROPERTY = "u2sa.mqtt.client";

  private final ScheduledThreadPoolExecutor thread = new ScheduledThreadPoolExecutor(1);

  @AfterEach
  void clear() {
    System.clearProperty(PROPERTY);
    thread.shutdownNow();
  }

  @Test
  void ofProcess_asThePropertySays() {
    assertThat(MqttClient.ofProcess()).isEqualTo(MqttClient.DIRECT);
    System.setProperty(PROPERTY, "paho");
    assertThat(MqttClient.ofProcess()).isEqualTo(MqttClient.PAHO);
    System.setProperty(PROPERTY, "hivemq");
    assertThatThrownBy(MqttClient::ofProcess)
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("u2sa.mqtt.client: \"hivemq\" is neither direct nor paho");
  }

  @Test
  void session_anyAddress_isTheClients() throws MqttException {
    assertThat(session(MqttClient.DIRECT, "tcp://127.0.0.1:1")).isInstanceOf(DirectSession.class);
    assertThat(session(MqttClient.DIRECT, "ssl://127.0.0.1:1")).isInstanceOf(DirectSession.class);
    assertThat(session(MqttClient.PAHO, "tcp://127.0.0.1:1")).isInstanceOf(PahoSession.class);
    assertThat(session(MqttClient.PAHO, "ssl://127.0.0.1:1")).isInstanceOf(PahoSession.class);
  }

  private MqttSession session(MqttClient client, String address) throws MqttException {
    return client.session(address, "id", thread, 1_000, null, new SystemClock());
  }
}
