package org.u2sa.interfaces.mqtt;

import java.util.Set;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.eclipse.paho.client.mqttv3.MqttException;

/**
 * A single-use MQTT session, so that no state of a broken link survives. Counts unconfirmed
 * messages.
 */
interface MqttSession {
  interface Owner {
    /**
     * Handles a received message; must not throw.
     *
     * @param isOld whether it is a retained message delivered on subscription
     */
    void arrived(String topicName, byte[] payload, boolean isOld);

    /** Reports a message that is too long to be received; must not throw. */
    void skipped(String topicName, int bytes);

    void lost(MqttSession session, String why);
  }

  /**
   * @throws MqttException if the broker does not answer or rejects the connection
   */
  void open(MqttConnectOptions options) throws MqttException;

  /**
   * Sends a message without blocking on the network.
   *
   * @param eachMatters whether the broker must confirm it (QoS 1)
   * @param confirmed run on confirmation; null for none
   * @return false if the session is over or has too many unconfirmed messages
   * @throws MqttException if it cannot be sent
   * @throws IllegalStateException if the message is too long
   */
  boolean publish(
      String topic, byte[] payload, boolean eachMatters, boolean retained, Runnable confirmed)
      throws MqttException;

  /** Waits for the broker's response, and returns the rejected filters. */
  Set<String> subscribe(boolean eachMatters, String... filters) throws MqttException;

  /** Whether the broker has answered a {@link #subscribe} of this filter, either way. */
  boolean hasAsked(String filter);

  void unsubscribe(String... filters) throws MqttException;

  boolean isOver();

  /**
   * Disconnects after pending messages are sent and, for QoS 1, confirmed. Returns the number of
   * messages that may be lost.
   */
  long close();

  /** Aborts without a DISCONNECT; returns the same count. Safe on an unopened session. */
  long abandon();

  /** Stops counting; returns the number of unconfirmed messages. */
  long end();

  /** Message of an error and its cause. */
  static String reason(Throwable e) {
    Throwable cause = e.getCause();
    return cause == null ? e.getMessage() : e.getMessage() + " (" + cause.getMessage() + ")";
  }
}
