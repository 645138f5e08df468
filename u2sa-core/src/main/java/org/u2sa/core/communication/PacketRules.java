package org.u2sa.core.communication;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.ByteBufUtil;
import io.netty.buffer.Unpooled;
import io.netty.handler.codec.mqtt.MqttPublishMessage;
import io.netty.handler.codec.mqtt.MqttQoS;
import java.util.Optional;
import org.u2sa.core.communication.access.ConnectRequest;
import org.u2sa.core.communication.access.SourceName;
import org.u2sa.core.communication.access.SourceNames;
import org.u2sa.core.communication.access.Speaker;
import org.u2sa.core.communication.access.TopicPermissions;
import org.u2sa.core.communication.limit.Allowance;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.core.security.AccessRule;
import org.u2sa.core.security.User;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.schema.U2SAData;

/** Rules for what one client may publish. Confined to its connection's thread. */
final class PacketRules {
  private static final double BYTES_OF_AN_ORDER = 4_096.0;

  private final BrokerState broker;
  private final User user; // null allows everything within the limits
  private final String owner; // owner of its retained messages
  private final TopicPermissions judge;
  private final Allowance orders;
  private final Speaker speaker;

  PacketRules(BrokerState broker, User user, String clientId) {
    this.broker = broker;
    this.user = user;
    owner = user == null ? "client " + clientId : "user " + user.name();
    judge = new TopicPermissions(broker.codec.types(), user);
    orders = new Allowance(broker.limits.clientOrdersPerSecond(), broker.nowMicros());
    speaker = new Speaker(user == null ? "" : user.name(), clientId);
  }

  /** Whether every service answers a message on the topic. */
  boolean isQuestion(String topic) {
    return judge.judge(topic).is(AccessRule.Kind.QUESTION);
  }

  /** Reason for refusing the message; if empty, it has been retained where requested. */
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
          String.format(
              "its payload of %s bytes is longer than the %s of %s",
              bytes, verdict.rule().longestPayload(), verdict.rule().type().name()));
    }
    if (verdict.is(AccessRule.Kind.ORDER) && !mayOrder(bytes)) {
      return Optional.of("too many orders of one client");
    }
    if (!mayName(verdict, publish.content())) {
      return Optional.of(SourceNames.TAKEN);
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
              ? Optional.of("retained messages require QoS 1") // its loss could go unnoticed
              : refusalAsRetained(verdict, payload);
      if (refusal.isEmpty()) {
        refusal = retain(verdict, payload);
      }
    }
    return refusal;
  }

  private boolean mayName(TopicPermissions.Verdict verdict, ByteBuf payload) {
    return broker.sources.mayPublish(
        verdict.topic(), verdict.rule(), payload, speaker, broker.nowMicros());
  }

  /** The source name of a message, or empty. */
  String sourceOf(MqttPublishMessage publish) {
    TopicPermissions.Verdict verdict = judge.judge(publish.variableHeader().topicName());
    return broker
        .sources
        .nameOf(verdict.topic(), verdict.rule(), publish.content())
        .map(SourceName::name)
        .orElse("");
  }

  /** Frees the names under which the client has published. */
  void leave() {
    broker.sources.leave(speaker);
  }

  /** Cost of an order; a long one counts as several. */
  private boolean mayOrder(int bytes) {
    boolean open = orders.isOpen(broker.nowMicros());
    if (open) {
      orders.take(1.0 + bytes / BYTES_OF_AN_ORDER);
    }
    return open;
  }

  /**
   * Reason for refusing the client as a member of the topic's system; empty if allowed or not a
   * system topic.
   */
  Optional<String> refusalOfSystem(String topic) {
    try {
      return user == null || user.mayEnter(Topic.parse(topic).systemId())
          ? Optional.empty()
          : Optional.of("it belongs to another system");
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  /**
   * Reason for refusing the will, or empty. A will is published when its sender is gone and cannot
   * answer for it, so it may report a lost service or stop, but not clear anything.
   */
  Optional<String> refusalOfWill(ConnectRequest.Will will) {
    TopicPermissions.Verdict verdict = judge.judge(will.topic());
    if (verdict.refusal() != null) {
      return Optional.of(verdict.refusal());
    }
    if (verdict.rule() != null && !verdict.rule().mayBeWill()) {
      return Optional.of(verdict.rule().type().name() + " is not a will");
    }
    if (will.payload().length > BrokerLimits.LONGEST_WILL) {
      return Optional.of("it is too long");
    }
    Optional<String> refusal =
        isEmergencyStop(verdict) ? refusalOfStop(verdict, will.payload(), true) : Optional.empty();
    if (refusal.isEmpty() && will.isRetained()) {
      refusal =
          will.eachMatters()
              ? refusalAsRetained(verdict, will.payload())
              : Optional.of("retained messages require QoS 1");
    }
    return refusal;
  }

  /**
   * Whether its sender may still use the source name of an accepted will when the connection ends.
   */
  boolean mayName(ConnectRequest.Will will) {
    return mayName(judge.judge(will.topic()), Unpooled.wrappedBuffer(will.payload()));
  }

  /** Retains an accepted will. Returns the reason if there is no room, or empty. */
  Optional<String> retain(ConnectRequest.Will will) {
    return retain(judge.judge(will.topic()), will.payload());
  }

  private static boolean isEmergencyStop(TopicPermissions.Verdict verdict) {
    return verdict.rule() != null && verdict.rule().channel().equals(Channels.EMERGENCY_STOP);
  }

  /**
   * A retained emergency stop may not be deleted, not even by users who may clear it: it would
   * remain in force in services that received it and be unknown to late subscribers.
   */
  private Optional<String> refusalOfStop(
      TopicPermissions.Verdict verdict, byte[] payload, boolean isWill) {
    Optional<U2SAData> message = read(verdict.topic(), payload);
    if (!(message.orElse(null) instanceof EmergencyStop stop)) {
      return Optional.of("it is not a readable emergency stop");
    }
    if (stop.active()) {
      return Optional.empty();
    }
    if (isWill) {
      return Optional.of("a will may not clear an emergency stop");
    }
    return user == null || user.mayClearEmergencyStop()
        ? Optional.empty()
        : Optional.of("only an operator may clear an emergency stop");
  }

  private Optional<String> retain(TopicPermissions.Verdict verdict, byte[] payload) {
    return broker.retained.enter(
        verdict.topic().toString(), owner, payload, verdict.is(AccessRule.Kind.URGENT));
  }

  /** Retention is allowed only on retaining channels, with each source under its own topic. */
  private Optional<String> refusalAsRetained(TopicPermissions.Verdict verdict, byte[] payload) {
    AccessRule rule = verdict.rule();
    if (rule != null && !rule.retained()) {
      return Optional.of(rule.channel().name() + " retains nothing");
    }
    if (payload.length > 0 || verdict.is(AccessRule.Kind.URGENT)) {
      Optional<U2SAData> message = read(verdict.topic(), payload);
      if (message.isEmpty()) {
        return Optional.of("it is retained but unreadable");
      }
      if (rule != null
          && !rule.channel().sourceOf(message.get()).equals(verdict.topic().source())) {
        return Optional.of("it is retained on the topic of another source");
      }
    }
    return Optional.empty();
  }

  private Optional<U2SAData> read(Topic topic, byte[] payload) {
    try {
      return Optional.of(broker.codec.decode(topic.typeChain(), payload));
    } catch (MalformedMessageException e) {
      return Optional.empty();
    }
  }
}
