package org.u2sa.interfaces.communication;

import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import org.eclipse.paho.client.mqttv3.MqttException;

/**
 * The channels that one MQTT connection wants to hear, whatever session it has, and those among
 * them that the broker does not let it hear. Safe for several threads.
 */
final class MqttSubscriptions {
  private final String address;
  private final String systemId;
  private final Consumer<String> trouble;
  private final Map<String, Channel<?>> wanted = new ConcurrentHashMap<>();
  private final Set<String> refused = ConcurrentHashMap.newKeySet();

  /**
   * @param address the broker's, for messages
   * @param trouble told what a broker does not allow or does not answer
   */
  MqttSubscriptions(String address, String systemId, Consumer<String> trouble) {
    this.address = address;
    this.systemId = systemId;
    this.trouble = trouble;
  }

  /** The channel of that name; null if it is not wanted. */
  Channel<?> named(String channelName) {
    return wanted.get(channelName);
  }

  /** Names of the channels that the broker refused. */
  Set<String> refused() {
    return new TreeSet<>(refused);
  }

  /** Takes note of a channel that is to be heard on every session. */
  void want(Channel<?> channel) {
    wanted.put(channel.name(), channel);
  }

  /** Takes {@link #want} back. */
  void forget(Channel<?> channel) {
    wanted.remove(channel.name());
    refused.remove(channel.name());
  }

  /**
   * Subscribes on a session.
   *
   * @return whether the broker consents, or will be asked on the next session as this one broke
   */
  boolean begin(MqttSession session, Channel<?> channel) {
    try {
      return ask(session, channel);
    } catch (MqttException e) {
      failed("subscribing to", channel, e);
      return session.isOver();
    }
  }

  /** Unsubscribes on a session; likewise. */
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
   * Subscribes to what the session was not asked for yet. What the broker refuses is left out, and
   * asked for anew on the next session.
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
    if (refused.add(channel.name())) { // said once, however often the link breaks
      trouble.accept(
          String.format(
              "the broker at %s refuses the subscription to \"%s\"; it is asked again at the next connection",
              address, channel));
    }
    return false;
  }

  private void failed(String what, Channel<?> channel, MqttException e) {
    trouble.accept(
        what + " \"" + channel + "\" at " + address + " failed: " + MqttSession.reason(e));
  }
}
