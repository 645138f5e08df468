package org.u2sa.interfaces.communication;

import java.util.Collections;
import java.util.Set;
import org.u2sa.messages.schema.U2SAData;

/** One service's connection to the Communication Manager. All calls are safe from any thread. */
public interface Connection extends AutoCloseable {
  /**
   * Which connection this is: a text that no other connection to the same Communication Manager
   * has. Health, discovery and the broker's word of a lost connection carry it, so that what is
   * said of a predecessor of the same name is not taken for this one. Stays the same when an
   * interrupted connection is made anew.
   */
  String instance();

  /**
   * Hands one frozen message over for delivery. Never waits for a subscriber.
   *
   * @return whether it was taken; a message that was not taken is counted in {@link #refused()}
   */
  boolean publish(Channel<?> channel, U2SAData message);

  /**
   * Begins to receive what is published on the channel by the services of the same system.
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
