package org.u2sa.interfaces.communication;

import java.util.Collections;
import java.util.Set;
import org.u2sa.messages.schema.U2SAData;

/** A service's connection to the Communication Manager. Thread-safe. */
public interface Connection extends AutoCloseable {
  /**
   * Unique ID of this connection, kept on reconnection. Health, discovery and the will carry it, so
   * that reports about a predecessor with the same name are not attributed to this service.
   */
  String instance();

  /**
   * Publishes a frozen message without waiting for subscribers; returns whether it was accepted.
   */
  boolean publish(Channel<?> channel, U2SAData message);

  /**
   * Starts receiving the channel's messages of the same system.
   *
   * @return whether the subscription was accepted, or will be requested again after an interruption
   */
  boolean subscribe(Channel<?> channel);

  /** Ends {@link #subscribe}. */
  boolean unsubscribe(Channel<?> channel);

  /**
   * Channels that the broker does not let this connection receive; retried on each reconnection.
   */
  default Set<String> refusedSubscriptions() {
    return Collections.emptySet();
  }

  /** Messages that were not delivered, or were received and not decodable. */
  long refused();

  /** Messages lost over MQTT, as detected from sequence numbers. */
  long missed();

  /** Ends all subscriptions and the connection. Idempotent. */
  @Override
  void close();
}
