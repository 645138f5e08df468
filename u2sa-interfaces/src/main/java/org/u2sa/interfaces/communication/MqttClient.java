package org.u2sa.interfaces.communication;

import java.util.Locale;
import java.util.concurrent.ScheduledExecutorService;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.u2sa.interfaces.time.Clock;

/** What speaks MQTT for a connection. All do alike, which the tests' contract holds. */
public enum MqttClient {
  /** Ours, where a connection is not encrypted; otherwise Paho. */
  DIRECT,
  /** Eclipse Paho. */
  PAHO;

  private static final String PROPERTY = "u2sa.mqtt.client";
  private static final String PLAIN = "tcp://";

  /**
   * The one that the property {@value #PROPERTY} of the Java virtual machine names.
   *
   * @throws IllegalArgumentException if there is none of that name
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

  /** What a process that this one starts is to be told: an option of its virtual machine. */
  public static String option() {
    return "-D" + PROPERTY + "=" + ofProcess();
  }

  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * A session that is not open yet.
   *
   * @param address {@code tcp://HOST:PORT} or {@code ssl://HOST:PORT}
   * @param linkThread looks after Paho's link
   * @throws MqttException if the address is none
   */
  MqttSession session(
      String address,
      String clientId,
      ScheduledExecutorService linkThread,
      long answerWithinMs,
      MqttConnection owner,
      Clock clock)
      throws MqttException {
    return this == DIRECT && address.startsWith(PLAIN)
        ? new DirectSession(address, clientId, answerWithinMs, owner, clock)
        : new PahoSession(address, clientId, linkThread, answerWithinMs, owner);
  }
}
