package org.u2sa.interfaces.communication;

import java.util.Set;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.eclipse.paho.client.mqttv3.MqttException;

/**
 * One MQTT session, from its opening until it breaks or is closed. It is used once, so that nothing
 * of a broken link comes back later. Counts the unconfirmed messages. Tells its {@link
 * MqttConnection} what arrives and when it breaks.
 */
interface MqttSession {
  /**
   * Begins the session.
   *
   * @throws MqttException if the broker does not answer, or refuses
   */
  void open(MqttConnectOptions options) throws MqttException;

  /**
   * Sends a message. Does not wait for the network.
   *
   * @param eachMatters whether the broker is to confirm it
   * @param confirmed run when the broker has confirmed it; null if nobody wants to know
   * @return whether it was taken; otherwise the session is over, or owes too many already
   * @throws MqttException if it cannot be sent
   * @throws IllegalStateException if it is too long
   */
  boolean publish(
      String topic, byte[] payload, boolean eachMatters, boolean retained, Runnable confirmed)
      throws MqttException;

  /**
   * Asks for messages and waits for the broker's answer.
   *
   * @return the filters that it refused; empty if it consented to all
   * @throws MqttException if it does not answer
   */
  Set<String> subscribe(boolean eachMatters, String... filters) throws MqttException;

  /** Whether the broker has answered {@link #subscribe} with this filter, either way. */
  boolean hasAsked(String filter);

  /** Ends {@link #subscribe}. */
  void unsubscribe(String... filters) throws MqttException;

  /** Whether the session broke or was ended. */
  boolean isOver();

  /**
   * Disconnects after the messages on their way, such as neutral commands, were sent and, where
   * each matters, confirmed.
   *
   * @return how many messages may not have arrived
   */
  long close();

  /** Cuts the session off without a DISCONNECT; likewise. Safe on one that was never open. */
  long abandon();

  /** Stops counting; returns how many messages were unconfirmed. */
  long end();

  /** An error's message and that of its cause. */
  static String reason(Throwable e) {
    Throwable cause = e.getCause();
    return cause == null ? e.getMessage() : e.getMessage() + " (" + cause.getMessage() + ")";
  }
}
