package org.u2sa.interfaces.communication;

import java.util.Collections;
import java.util.Set;
import org.u2sa.messages.schema.U2SAData;

/** A service's connection to the Communication Manager. Thread-safe. */
public interface Connection extends AutoCloseable {
  /**
   * Unique identifier of this connection at the Communication Manager. Health, discovery and the
   * will message carry it, so that reports about a predecessor of the same name are not mistaken
   * for this one. Kept on reconnection.
   */
  String instance();

  /**
   * Publishes a frozen message. Never waits for subscribers.
   *
   * @return whether it was accepted; rejected messages are counted in {@link #refused()}
   */
  boolean publish(Channel<?> channel, U2SAData message);

  /**
   * Starts receiving messages published on the channel by services of the same system.
   *
   * @return whether the Communication Manager accepted the subscription, or will be asked again
   *     after an interruption
   */
  boolean subscribe(Channel<?> channel);

  /** Ends {@link #subscribe}. */
  boolean unsubscribe(Channel<?> channel);

  /**
   * Names of subscribed channels that the broker does not permit this connection to receive.
   * Retried on each reconnection.
   */
  default Set<String> refusedSubscriptions() {
    return Collections.emptySet();
  }

  /**
   * Number of messages that could not be delivered, or were received but could not be decoded,
   * since the connection was created.
   */
  long refused();

  /**
   * Number of messages on subscribed channels lost over MQTT since the connection was created, as
   * detected from sequence numbers.
   */
  long missed();

  /** Ends all subscriptions and the connection. Idempotent. */
  @Override
  void close();
}
