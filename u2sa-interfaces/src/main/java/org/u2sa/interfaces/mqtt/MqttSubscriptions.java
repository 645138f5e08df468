package org.u2sa.interfaces.mqtt;

import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Topic;

/**
 * Subscribed channels of a connection, across sessions, and those the broker rejected. Thread-safe.
 */
final class MqttSubscriptions {
  private final String address;
  private final String systemId;
  private final Consumer<String> trouble;
  private final Map<String, Channel<?>> wanted = new ConcurrentHashMap<>();
  private final Set<String> refused = ConcurrentHashMap.newKeySet();

  /**
   * @param trouble notified of rejected or unanswered requests
   */
  MqttSubscriptions(String address, String systemId, Consumer<String> trouble) {
    this.address = address;
    this.systemId = systemId;
    this.trouble = trouble;
  }

  /** Subscribed channel by name; null if not subscribed. */
  Channel<?> named(String channelName) {
    return wanted.get(channelName);
  }

  Set<String> refused() {
    return new TreeSet<>(refused);
  }

  void want(Channel<?> channel) {
    wanted.put(channel.name(), channel);
  }

  void forget(Channel<?> channel) {
    wanted.remove(channel.name());
    refused.remove(channel.name());
  }

  /**
   * Returns whether the broker accepts, or will be asked on the next session because this one
   * broke.
   */
  boolean begin(MqttSession session, Channel<?> channel) {
    try {
      return ask(session, channel);
    } catch (MqttException e) {
      failed("subscribing to", channel, e);
      return session.isOver();
    }
  }

  boolean end(MqttSession session, Channel<?> channel) {
    try {
      session.unsubscribe(Topic.filter(systemId, channel));
      return true;
    } catch (MqttException e) {
      failed("unsubscribing from", channel, e);
      return session.isOver();
    }
  }

  /**
   * Subscribes to channels not yet requested on this session; rejected ones wait for the next.
   *
   * @throws MqttException if the broker does not answer
   */
  void renew(MqttSession session) throws MqttException {
    for (Channel<?> channel : wanted.values()) {
      if (!session.hasAsked(Topic.filter(systemId, channel))) {
        ask(session, channel);
      }
    }
  }

  private boolean ask(MqttSession session, Channel<?> channel) throws MqttException {
    if (session.subscribe(true, Topic.filter(systemId, channel)).isEmpty()) {
      refused.remove(channel.name());
      return true;
    }
    if (refused.add(channel.name())) { // reported once, however often the link breaks
      trouble.accept(
          String.format(
              "the broker at %s rejects the subscription to \"%s\"; retried at the next connection",
              address, channel));
    }
    return false;
  }

  private void failed(String what, Channel<?> channel, MqttException e) {
    trouble.accept(
        what + " \"" + channel + "\" at " + address + " failed: " + MqttSession.reason(e));
  }
}
