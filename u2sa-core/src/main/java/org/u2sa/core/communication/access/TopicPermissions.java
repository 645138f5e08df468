package org.u2sa.core.communication.access;

import java.util.Collections;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.core.security.AccessRule;
import org.u2sa.core.security.AccessTable;
import org.u2sa.core.security.User;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;

/**
 * Publishing permissions of one client by topic: by channel and by the type to which a reader
 * resolves the type chain. Not thread-safe.
 */
public final class TopicPermissions {
  private static final int TOPICS_REMEMBERED = 256;

  /**
   * Result of a check.
   *
   * @param refusal reason for refusing; null if allowed
   * @param topic parsed topic; null if malformed
   * @param rule row of the table; null on non-standard channels
   */
  public record Verdict(String refusal, Topic topic, AccessRule rule) {
    /** Whether the topic is of this kind. */
    public boolean is(AccessRule.Kind kind) {
      return rule != null && rule.kind() == kind;
    }
  }

  private final MessageTypes types;
  private final User user; // null: has every role
  private final Map<String, Verdict> verdicts = new HashMap<>();

  /**
   * @param user the client's user; null has every role
   */
  public TopicPermissions(MessageTypes types, User user) {
    this.types = types;
    this.user = user;
  }

  /** Cached verdict: a topic's verdict never changes, and a client has few topics. */
  public Verdict judge(String topic) {
    Verdict known = verdicts.get(topic);
    if (known == null && BrokerLimits.isTooLong(topic)) {
      return new Verdict("its topic is too long", null, null);
    }
    if (known == null) {
      known = judgeAnew(topic);
      if (verdicts.size() < TOPICS_REMEMBERED) {
        verdicts.put(topic, known);
      }
    }
    return known;
  }

  private Verdict judgeAnew(String text) {
    Topic topic;
    MessageType<?> type;
    try {
      topic = Topic.parse(text);
      type = types.nearest(topic.typeChain());
    } catch (IllegalArgumentException e) {
      return new Verdict("its topic is not a U2SA topic", null, null);
    } catch (MalformedMessageException e) {
      return new Verdict("its types are not a class and its ancestors", null, null);
    }
    if (!topic.toString().equals(text)) { // only the canonical form is allowed
      return new Verdict("its topic is not a U2SA topic", null, null);
    }
    if (user != null && !user.mayEnter(topic.systemId())) {
      return new Verdict("it belongs to another system", topic, null);
    }
    return Channels.named(topic.channel()).isPresent()
        ? onStandardChannel(topic, type)
        : onOwnChannel(topic, type);
  }

  private Verdict onStandardChannel(Topic topic, MessageType<?> type) {
    Optional<AccessRule> rule = AccessTable.rule(topic.channel(), type);
    if (rule.isPresent()
        && !topic.source().isEmpty()
        && !rule.get().channel().isRetainedBySource()) {
      return new Verdict("its topic is not a U2SA topic", topic, null);
    }
    if (rule.isEmpty()) {
      return new Verdict(topic.channel() + " does not carry " + type.name(), topic, null);
    }
    boolean may = user == null || !Collections.disjoint(user.roles(), rule.get().roles());
    return may
        ? new Verdict(null, topic, rule.get())
        : new Verdict(forbidden(topic.channel(), type), topic, rule.get());
  }

  private Verdict onOwnChannel(Topic topic, MessageType<?> type) {
    return user == null || AccessTable.mayPublishOnOwnChannel(user.roles(), type)
        ? new Verdict(null, topic, null)
        : new Verdict(forbidden("its own channels", type), topic, null);
  }

  private String forbidden(String where, MessageType<?> type) {
    return "role " + user.rolesText() + " may not publish on " + where + " (" + type.name() + ")";
  }
}
