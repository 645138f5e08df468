package org.u2sa.core.communication;

import io.netty.buffer.ByteBufUtil;
import io.netty.handler.codec.mqtt.MqttMessageBuilders;
import io.netty.handler.codec.mqtt.MqttPublishMessage;
import io.netty.handler.codec.mqtt.MqttQoS;
import io.netty.handler.codec.mqtt.MqttSubAckMessage;
import io.netty.handler.codec.mqtt.MqttSubscribeMessage;
import io.netty.handler.codec.mqtt.MqttTopicSubscription;
import io.netty.handler.codec.mqtt.MqttUnsubscribeMessage;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.core.security.User;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.MalformedMessageException;
import org.u2sa.messages.U2SAData;
import org.u2sa.messages.contract.EmergencyStop;

/** What one client's packets may do. Belongs to its connection's thread. */
final class PacketRules {
  private static final int TOPICS_REMEMBERED = 256;

  private final BrokerDoor door;
  private final User user; // null: everything within the limits
  private final String clientId;
  private final Set<String> filters = new HashSet<>();
  private final Map<String, Optional<String>> refusalByTopic = new HashMap<>();

  PacketRules(BrokerDoor door, User user, String clientId) {
    this.door = door;
    this.user = user;
    this.clientId = clientId;
  }

  /** Why the message may not be published; empty if it may. */
  Optional<String> refusalOf(MqttPublishMessage publish) {
    String topic = publish.variableHeader().topicName();
    Optional<String> refusal = refusalOfTopic(topic);
    if (refusal.isPresent()) {
      return refusal;
    }
    if (publish.content().readableBytes() > BrokerLimits.LONGEST_PAYLOAD) {
      return Optional.of("its payload is too long");
    }
    if (publish.fixedHeader().isRetain() && !door.mayRetain(topic)) {
      return Optional.of("too many retained topics");
    }
    return topic.indexOf("/emergency-stop/") < 0 || user == null || user.mayClearEmergencyStop()
        ? Optional.empty()
        : refusalOfStop(topic, ByteBufUtil.getBytes(publish.content()));
  }

  /** Why the client may not come as one of the topic's system; empty if it may, or it is none. */
  Optional<String> refusalOfSystem(String topic) {
    try {
      return user == null || user.mayEnter(Topic.parse(topic).systemId())
          ? Optional.empty()
          : Optional.of("it is another system");
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  /** Why the client may not have that will; empty if it may. */
  Optional<String> refusalOfWill(String topic, Introduction said) {
    Optional<String> refusal = refusalOfTopic(topic);
    if (refusal.isEmpty() && said.isWillRetained() && !door.mayRetain(topic)) {
      refusal = Optional.of("too many retained topics");
    }
    if (refusal.isEmpty()
        && topic.indexOf("/emergency-stop/") >= 0
        && user != null
        && !user.mayClearEmergencyStop()) {
      refusal = refusalOfStop(topic, said.will());
    }
    return refusal;
  }

  /** A topic's answer does not change, and a client has few topics. */
  private Optional<String> refusalOfTopic(String topic) {
    Optional<String> known = refusalByTopic.get(topic);
    if (known == null) {
      known = judge(topic);
      if (refusalByTopic.size() < TOPICS_REMEMBERED) {
        refusalByTopic.put(topic, known);
      }
    }
    return known;
  }

  private Optional<String> judge(String text) {
    if (isTooLong(text)) {
      return Optional.of("its topic is too long");
    }
    if (user == null) {
      return Optional.empty();
    }
    Topic topic;
    try {
      topic = Topic.parse(text);
    } catch (IllegalArgumentException e) {
      return Optional.of("its topic is none of U2SA");
    }
    if (!user.mayEnter(topic.systemId())) {
      return Optional.of("it is another system");
    }
    return user.mayPublish(topic)
        ? Optional.empty()
        : Optional.of("role " + user.rolesText() + " may not publish on " + known(topic));
  }

  private static String known(Topic topic) {
    return Channels.named(topic.channel()).isPresent() ? topic.channel() : "its own channels";
  }

  /** Who may not clear an emergency stop may not delete the retained one either. */
  private Optional<String> refusalOfStop(String topic, byte[] payload) {
    try {
      U2SAData message = door.codec().decode(Topic.parse(topic).typeChain(), payload);
      if (message instanceof EmergencyStop && ((EmergencyStop) message).active()) {
        return Optional.empty();
      }
      return Optional.of("only an operator clears an emergency stop");
    } catch (MalformedMessageException | IllegalArgumentException e) {
      return Optional.of("it is no emergency stop that can be read");
    }
  }

  /** Why the client may not subscribe so; what it hears is looked at again message by message. */
  Optional<String> refusalOf(MqttSubscribeMessage subscribe) {
    for (MqttTopicSubscription wanted : subscribe.payload().topicSubscriptions()) {
      String filter = wanted.topicFilter();
      if (isTooLong(filter)) {
        return Optional.of("a filter is too long");
      }
      if (filters.size() >= BrokerLimits.FILTERS_PER_CLIENT && !filters.contains(filter)) {
        return Optional.of("it has too many filters");
      }
      filters.add(filter);
    }
    return Optional.empty();
  }

  static MqttSubAckMessage refusedAnswer(MqttSubscribeMessage subscribe) {
    MqttMessageBuilders.SubAckBuilder answer =
        MqttMessageBuilders.subAck().packetId(subscribe.variableHeader().messageId());
    subscribe
        .payload()
        .topicSubscriptions()
        .forEach(filter -> answer.addGrantedQos(MqttQoS.FAILURE));
    return answer.build();
  }

  void unsubscribed(MqttUnsubscribeMessage unsubscribe) {
    filters.removeAll(unsubscribe.payload().topics());
  }

  private static boolean isTooLong(String topic) {
    return topic.length() > BrokerLimits.LONGEST_TOPIC
        || topic.chars().filter(letter -> letter == '/').count() >= BrokerLimits.DEEPEST_TOPIC;
  }

  @Override
  public String toString() {
    return clientId;
  }
}
