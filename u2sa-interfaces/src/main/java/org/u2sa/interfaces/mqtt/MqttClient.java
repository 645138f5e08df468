package org.u2sa.interfaces.mqtt;

import java.util.Locale;
import java.util.concurrent.ScheduledExecutorService;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.u2sa.interfaces.time.Clock;

/** MQTT client implementations, interchangeable as verified by contract tests. */
public enum MqttClient {
  /** Our own. */
  DIRECT,
  /** Eclipse Paho. */
  PAHO;

  private static final String PROPERTY = "u2sa.mqtt.client";

  /**
   * Client selected by the system property {@value #PROPERTY}.
   *
   * @throws IllegalArgumentException if the name is unknown
   */
  static MqttClient ofProcess() {
    String name = System.getProperty(PROPERTY, DIRECT.toString());
    for (MqttClient client : values()) {
      if (client.toString().equals(name)) {
        return client;
      }
    }
    throw new IllegalArgumentException(PROPERTY + ": \"" + name + "\" is neither direct nor paho");
  }

  /** JVM option that passes the selection to child processes. */
  public static String option() {
    return "-D" + PROPERTY + "=" + ofProcess();
  }

  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * @param address {@code tcp://HOST:PORT} or {@code ssl://HOST:PORT}
   * @param linkThread maintains Paho's link
   * @throws MqttException if the address is invalid
   */
  MqttSession session(
      String address,
      String clientId,
      ScheduledExecutorService linkThread,
      long answerWithinMs,
      MqttSession.Owner owner,
      Clock clock)
      throws MqttException {
    return this == DIRECT
        ? new DirectSession(address, clientId, answerWithinMs, owner, clock)
        : new PahoSession(address, clientId, linkThread, answerWithinMs, owner);
  }
}
