package org.u2sa.core.communication;

import io.netty.handler.codec.mqtt.MqttMessage;
import io.netty.handler.codec.mqtt.MqttMessageBuilders;
import io.netty.handler.codec.mqtt.MqttPublishMessage;
import io.netty.handler.codec.mqtt.MqttQoS;
import io.netty.handler.codec.mqtt.MqttSubAckMessage;
import io.netty.handler.codec.mqtt.MqttSubscribeMessage;
import io.netty.handler.codec.mqtt.MqttSubscribePayload;
import io.netty.handler.codec.mqtt.MqttTopicSubscription;
import io.netty.handler.codec.mqtt.MqttUnsubscribeMessage;
import io.netty.handler.codec.mqtt.MqttUnsubscribePayload;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.core.communication.limit.Allowance;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.core.communication.routing.TopicFilter;

/**
 * One client's subscriptions, and the cost of its packets in queries. Confined to its connection's
 * thread.
 */
final class ClientSubscriptions {
  private static final double TOPICS_OF_A_QUESTION = 4_096.0;
  private static final double COMPARISONS_PER_S = 25_000.0; // matching new topics against filters
  private static final double COMPARISONS_AT_ONCE = 50_000.0;
  private static final double RETAINED_OF_A_QUESTION = 64.0;
  private static final String SHARED = "$share/";

  private final BrokerState broker;
  private final PacketRules rules;
  private final String name;
  private final String connection;
  private final Allowance newTopics;
  private final Set<String> filters = new HashSet<>();

  ClientSubscriptions(BrokerState broker, PacketRules rules, String name, String connection) {
    this.broker = broker;
    this.rules = rules;
    this.name = name;
    this.connection = connection;
    newTopics = new Allowance(COMPARISONS_PER_S, COMPARISONS_AT_ONCE, broker.nowMicros());
  }

  /**
   * Whether a packet may be accepted now; if so, charges it to the allowances. Queries are limited
   * per user, because every service answers them; messages on new topics per connection, so that no
   * other connection can delay a stop.
   */
  boolean isInTurn(MqttMessage packet) {
    double questions = questions(packet);
    if (questions > 0.0) {
      return broker.questions.take(name, questions, broker.nowMicros());
    }
    return !(packet instanceof MqttPublishMessage publish)
        || isInTurn(publish.variableHeader().topicName());
  }

  /**
   * Whether a message on the topic may be accepted now; a topic new to the broker is matched
   * against all clients' filters and charged for it.
   */
  private boolean isInTurn(String topic) {
    int compared = broker.subscriptions.filters();
    if (compared == 0 || broker.subscriptions.isRemembered(topic)) {
      return true;
    }
    boolean isOpen = newTopics.isOpen(broker.nowMicros());
    if (isOpen) {
      newTopics.take(compared);
    }
    return isOpen;
  }

  /**
   * Cost of a packet in queries: one if it queries every service or changes subscriptions. Further
   * filters cost in proportion to the topics they are matched against.
   */
  double questions(MqttMessage packet) {
    if (packet.payload() instanceof MqttSubscribePayload wanted) {
      return questions(wanted.topicSubscriptions().size());
    }
    if (packet.payload() instanceof MqttUnsubscribePayload unwanted) {
      return questions(unwanted.topics().size());
    }
    return packet instanceof MqttPublishMessage publish
            && rules.isQuestion(publish.variableHeader().topicName())
        ? 1.0
        : 0.0;
  }

  private double questions(int filters) {
    int topics = broker.subscriptions.topics() + broker.retained.topics().size();
    return 1.0 + (filters - 1) * topics / TOPICS_OF_A_QUESTION;
  }

  /**
   * Adds all subscriptions or none; access is checked again for each message delivered.
   *
   * @return the reason for refusing, or empty
   */
  Optional<String> refusalOf(MqttSubscribeMessage subscribe) {
    Map<String, Boolean> eachMatters = filtersOf(subscribe);
    for (String wanted : eachMatters.keySet()) {
      if (BrokerLimits.isTooLong(wanted)) {
        return Optional.of("a filter is too long");
      }
      if (!TopicFilter.isValid(wanted)) {
        return Optional.of("a filter is invalid");
      }
      if (wanted.startsWith(SHARED)) { // MQTT 5 shared subscription
        return Optional.of("a filter is shared");
      }
    }
    Set<String> added = new HashSet<>(eachMatters.keySet());
    added.removeAll(filters);
    if (filters.size() + added.size() > BrokerLimits.FILTERS_PER_CLIENT) {
      return Optional.of("it has too many filters");
    }
    if (!added.isEmpty()
        && broker.subscriptions.ofUser(name) + added.size() > BrokerLimits.FILTERS_PER_USER) {
      return Optional.of("its user has too many filters");
    }
    filters.addAll(added);
    eachMatters.forEach((wanted, each) -> broker.subscriptions.add(connection, name, wanted, each));
    return Optional.empty();
  }

  /** The filters, each with whether it requests QoS 1; the last of equal filters wins. */
  private static Map<String, Boolean> filtersOf(MqttSubscribeMessage subscribe) {
    Map<String, Boolean> eachMatters = new LinkedHashMap<>();
    for (MqttTopicSubscription one : subscribe.payload().topicSubscriptions()) {
      eachMatters.put(one.topicFilter(), one.qualityOfService() != MqttQoS.AT_MOST_ONCE);
    }
    return eachMatters;
  }

  /** Sends the retained messages to a client that has subscribed. */
  void sendRetained(MqttSubscribeMessage subscribe, Client subscriber) {
    int sent = broker.router.sendRetained(filtersOf(subscribe), subscriber);
    broker.questions.charge(name, sent / RETAINED_OF_A_QUESTION, broker.nowMicros());
  }

  /** The answer to SUBSCRIBE. No channel uses QoS 2, so 1 is the most that is granted. */
  static MqttSubAckMessage answerTo(MqttSubscribeMessage subscribe, boolean isRefused) {
    MqttMessageBuilders.SubAckBuilder answer =
        MqttMessageBuilders.subAck().packetId(subscribe.variableHeader().messageId());
    for (MqttTopicSubscription one : subscribe.payload().topicSubscriptions()) {
      boolean eachMatters = one.qualityOfService() != MqttQoS.AT_MOST_ONCE;
      answer.addGrantedQos(
          isRefused ? MqttQoS.FAILURE : eachMatters ? MqttQoS.AT_LEAST_ONCE : MqttQoS.AT_MOST_ONCE);
    }
    return answer.build();
  }

  /** Removes subscriptions; unknown filters are ignored. */
  void unsubscribe(MqttUnsubscribeMessage packet) {
    for (String unwanted : packet.payload().topics()) {
      if (filters.remove(unwanted)) {
        broker.subscriptions.remove(connection, unwanted);
      }
    }
  }
}
