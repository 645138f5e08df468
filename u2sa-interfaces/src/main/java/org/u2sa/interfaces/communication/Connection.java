package org.u2sa.interfaces.communication;

import java.util.Collections;
import java.util.Set;
import org.u2sa.messages.schema.U2SAData;

/** A service's connection to the Communication Manager. Thread-safe. */
public interface Connection extends AutoCloseable {
  /**
   * Unique identifier of this connection at the Communication Manager. Health, discovery and the
   * will message carry it, so that reports about a predecessor of the same name are not mistaken
   * for this one. Unchanged by reconnection.
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
   * @return whether the Communication Manager took the subscription (one that comes back after an
   *     interruption counts)
   */
  boolean subscribe(Channel<?> channel);

  /** Ends {@link #subscribe}. */
  boolean unsubscribe(Channel<?> channel);

  /**
   * Names of the channels that were subscribed to and that the broker does not let this connection
   * hear. It is asked again whenever the connection is made anew.
   */
  default Set<String> refusedSubscriptions() {
    return Collections.emptySet();
  }

  /**
   * Messages that could not be handed over, or that came in and could not be read, since the
   * connection was made.
   */
  long refused();

  /**
   * Messages of the subscribed channels that others sent over MQTT and that were lost on the way,
   * as far as their numbers tell, since the connection was made.
   */
  long missed();

  /** Ends all subscriptions and the connection. Safe to call twice. */
  @Override
  void close();
}
