package org.u2sa.core.communication;

import io.netty.buffer.ByteBufUtil;
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
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.core.security.AccessRule;
import org.u2sa.core.security.User;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.contract.EmergencyStop;
import org.u2sa.messages.schema.MalformedMessageException;
import org.u2sa.messages.schema.U2SAData;

/** What one client's packets may do. Belongs to its connection's thread. */
final class PacketRules {
  private static final double BYTES_OF_AN_ORDER = 4_096.0;
  private static final double TOPICS_OF_A_QUESTION = 4_096.0;

  private final ConnectionFilter filter;
  private final User user; // null: everything within the limits
  private final String owner; // of what it has retained
  private final String name; // whose filters are counted together
  private final String connection;
  private final TopicPermissions judge;
  private final Allowance orders;
  private final Set<String> filters = new HashSet<>();

  PacketRules(ConnectionFilter filter, User user, String clientId, String connection) {
    this.connection = connection;
    this.filter = filter;
    this.user = user;
    owner = user == null ? "client " + clientId : "user " + user.name();
    name = user == null ? ConnectionFilter.ANONYMOUS : user.name();
    judge = new TopicPermissions(filter.codec().types(), user);
    orders = new Allowance(filter.limits().clientOrdersPerSecond(), filter.nowMicros());
  }

  /**
   * How many questions a packet counts as: one if it is a query to every service or changes
   * subscriptions. Each further filter counts the more, the more topics it is compared with.
   */
  double questions(MqttMessage packet) {
    if (packet.payload() instanceof MqttSubscribePayload wanted) {
      return questions(wanted.topicSubscriptions().size());
    }
    if (packet.payload() instanceof MqttUnsubscribePayload unwanted) {
      return questions(unwanted.topics().size());
    }
    return packet instanceof MqttPublishMessage publish
            && judge.judge(publish.variableHeader().topicName()).is(AccessRule.Kind.QUESTION)
        ? 1.0
        : 0.0;
  }

  private double questions(int filters) {
    int topics = filter.subscriptions().topics() + filter.retained().topics().size();
    return 1.0 + (filters - 1) * topics / TOPICS_OF_A_QUESTION;
  }

  /** Why the message may not be published; empty if it may. */
  Optional<String> refusalOf(MqttPublishMessage publish) {
    TopicPermissions.Verdict verdict = judge.judge(publish.variableHeader().topicName());
    if (verdict.refusal() != null) {
      return Optional.of(verdict.refusal());
    }
    int bytes = publish.content().readableBytes();
    if (bytes > BrokerLimits.LONGEST_PAYLOAD) {
      return Optional.of("its payload is too long");
    }
    if (verdict.rule() != null && bytes > verdict.rule().longestPayload()) {
      return Optional.of(
          "its payload of "
              + bytes
              + " bytes is longer than the "
              + verdict.rule().longestPayload()
              + " of "
              + verdict.rule().type().name());
    }
    if (verdict.is(AccessRule.Kind.ORDER) && !mayOrder(bytes)) {
      return Optional.of("too many orders of one client");
    }
    boolean retained = publish.fixedHeader().isRetain();
    boolean stop = isEmergencyStop(verdict);
    if (!retained && !stop) {
      return Optional.empty();
    }
    byte[] payload = ByteBufUtil.getBytes(publish.content());
    Optional<String> refusal = stop ? refusalOfStop(verdict, payload, false) : Optional.empty();
    if (refusal.isEmpty() && retained) {
      refusal =
          publish.fixedHeader().qosLevel() == MqttQoS.AT_MOST_ONCE
              ? Optional.of("it is to be retained and has QoS 0") // Moquette deletes what it held
              : refusalOfRetained(verdict, payload);
    }
    return refusal;
  }

  /** A long order counts as several. */
  private boolean mayOrder(int bytes) {
    boolean open = orders.isOpen(filter.nowMicros());
    if (open) {
      orders.take(1.0 + bytes / BYTES_OF_AN_ORDER);
    }
    return open;
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

  /**
   * Why the client may not have that will; empty if it may. A will is said when nobody is there any
   * more who would answer for it: it says that a service is lost, or stops, and clears nothing.
   */
  Optional<String> refusalOfWill(String topic, ConnectRequest said) {
    TopicPermissions.Verdict verdict = judge.judge(topic);
    if (verdict.refusal() != null) {
      return Optional.of(verdict.refusal());
    }
    if (verdict.rule() != null && !verdict.rule().mayBeWill()) {
      return Optional.of(verdict.rule().type().name() + " is no will");
    }
    if (said.will().length > BrokerLimits.LONGEST_WILL) {
      return Optional.of("it is too long");
    }
    Optional<String> refusal =
        isEmergencyStop(verdict) ? refusalOfStop(verdict, said.will(), true) : Optional.empty();
    if (refusal.isEmpty() && said.isWillRetained()) {
      refusal =
          said.willQuality() == 0
              ? Optional.of("it is to be retained and has QoS 0")
              : refusalOfRetained(verdict, said.will());
    }
    return refusal;
  }

  private static boolean isEmergencyStop(TopicPermissions.Verdict verdict) {
    return verdict.rule() != null && verdict.rule().channel().equals(Channels.EMERGENCY_STOP);
  }

  /**
   * Who may not clear an emergency stop may not delete the retained one either; nor may those who
   * may clear it, since a deleted one stands on where it was heard and is unknown to latecomers.
   */
  private Optional<String> refusalOfStop(
      TopicPermissions.Verdict verdict, byte[] payload, boolean isWill) {
    Optional<U2SAData> message = read(verdict.topic(), payload);
    if (!(message.orElse(null) instanceof EmergencyStop stop)) {
      return Optional.of("it is no emergency stop that can be read");
    }
    if (stop.active()) {
      return Optional.empty();
    }
    if (isWill) {
      return Optional.of("a will clears no emergency stop");
    }
    return user == null || user.mayClearEmergencyStop()
        ? Optional.empty()
        : Optional.of("only an operator clears an emergency stop");
  }

  /** Only channels that retain do, each source's message under its own topic, as room allows. */
  private Optional<String> refusalOfRetained(TopicPermissions.Verdict verdict, byte[] payload) {
    AccessRule rule = verdict.rule();
    if (rule != null && !rule.retained()) {
      return Optional.of(rule.channel().name() + " retains nothing");
    }
    boolean urgent = verdict.is(AccessRule.Kind.URGENT);
    if (payload.length > 0 || urgent) {
      Optional<U2SAData> message = read(verdict.topic(), payload);
      if (message.isEmpty()) {
        return Optional.of("it is to be retained and cannot be read");
      }
      if (rule != null
          && !rule.channel().sourceOf(message.get()).equals(verdict.topic().source())) {
        return Optional.of("it is retained for another source than it names");
      }
    }
    return filter.retained().enter(verdict.topic().toString(), owner, payload.length, urgent);
  }

  private Optional<U2SAData> read(Topic topic, byte[] payload) {
    try {
      return Optional.of(filter.codec().decode(topic.typeChain(), payload));
    } catch (MalformedMessageException e) {
      return Optional.empty();
    }
  }

  /**
   * Enters subscriptions, all or none; what the client hears is looked at again message by message.
   *
   * @return why it may not subscribe to them; empty if it may
   */
  Optional<String> refusalOf(MqttSubscribeMessage subscribe) {
    Map<String, Boolean> eachMatters = new LinkedHashMap<>(); // by filter; the last of one counts
    for (MqttTopicSubscription one : subscribe.payload().topicSubscriptions()) {
      if (BrokerLimits.isTooLong(one.topicFilter())) {
        return Optional.of("a filter is too long");
      }
      if (!TopicFilter.isValid(one.topicFilter())) {
        return Optional.of("a filter is none");
      }
      eachMatters.put(one.topicFilter(), one.qualityOfService() != MqttQoS.AT_MOST_ONCE);
    }
    Set<String> added = new HashSet<>(eachMatters.keySet());
    added.removeAll(filters);
    if (filters.size() + added.size() > BrokerLimits.FILTERS_PER_CLIENT) {
      return Optional.of("it has too many filters");
    }
    if (!added.isEmpty()
        && filter.subscriptions().ofUser(name) + added.size() > BrokerLimits.FILTERS_PER_USER) {
      return Optional.of("its user has too many filters");
    }
    filters.addAll(added);
    eachMatters.forEach(
        (wanted, each) -> filter.subscriptions().add(connection, name, wanted, each));
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

  /**
   * Ends subscriptions.
   *
   * @return the packet with those filters only that the client had subscribed, since Moquette
   *     spends time on each of the others too; empty if there are none
   */
  Optional<MqttUnsubscribeMessage> unsubscribed(MqttUnsubscribeMessage unsubscribe) {
    List<String> known = new ArrayList<>();
    for (String unwanted : unsubscribe.payload().topics()) {
      if (filters.remove(unwanted)) {
        known.add(unwanted);
        filter.subscriptions().remove(connection, unwanted);
      }
    }
    return known.isEmpty()
        ? Optional.empty()
        : Optional.of(
            new MqttUnsubscribeMessage(
                unsubscribe.fixedHeader(),
                unsubscribe.variableHeader(),
                new MqttUnsubscribePayload(known)));
  }
}
