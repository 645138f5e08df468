package org.u2sa.interfaces.mqtt;

import java.util.Set;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.eclipse.paho.client.mqttv3.MqttException;

/**
 * A single-use MQTT session, from opening until it breaks or is closed, so that no state of a
 * broken link survives. Counts unconfirmed messages and notifies its {@link Owner} of messages and
 * loss.
 */
interface MqttSession {
  /** Receives what happens on a session's threads. */
  interface Owner {
    /**
     * Handles a received message. Must not throw.
     *
     * @param isOld whether it is a retained message delivered on subscription
     */
    void arrived(String topicName, byte[] payload, boolean isOld);

    /** Called when the session has broken. */
    void lost(MqttSession session, String why);
  }

  /**
   * Opens the session.
   *
   * @throws MqttException if the broker does not answer or rejects the connection
   */
  void open(MqttConnectOptions options) throws MqttException;

  /**
   * Sends a message without blocking on the network.
   *
   * @param eachMatters whether the broker must confirm it (QoS 1)
   * @param confirmed run on confirmation; null for none
   * @return whether it was accepted; if not, the session is over or has too many unconfirmed
   *     messages
   * @throws MqttException if it cannot be sent
   * @throws IllegalStateException if the message is too long
   */
  boolean publish(
      String topic, byte[] payload, boolean eachMatters, boolean retained, Runnable confirmed)
      throws MqttException;

  /**
   * Subscribes and waits for the broker's response.
   *
   * @return rejected filters; empty if all were accepted
   * @throws MqttException if it does not answer
   */
  Set<String> subscribe(boolean eachMatters, String... filters) throws MqttException;

  /** Whether the broker has answered a {@link #subscribe} of this filter, either way. */
  boolean hasAsked(String filter);

  /** Unsubscribes. */
  void unsubscribe(String... filters) throws MqttException;

  /** Whether the session has broken or was closed. */
  boolean isOver();

  /**
   * Disconnects after pending messages, such as neutral commands, are sent and, for QoS 1,
   * confirmed.
   *
   * @return number of messages that may be lost
   */
  long close();

  /** Aborts the session without a DISCONNECT; returns likewise. Safe on an unopened session. */
  long abandon();

  /** Stops counting; returns the number of unconfirmed messages. */
  long end();

  /** Message of an error and its cause. */
  static String reason(Throwable e) {
    Throwable cause = e.getCause();
    return cause == null ? e.getMessage() : e.getMessage() + " (" + cause.getMessage() + ")";
  }
}
