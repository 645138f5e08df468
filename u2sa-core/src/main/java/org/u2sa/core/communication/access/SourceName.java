package org.u2sa.core.communication.access;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.ByteBufUtil;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.core.security.AccessRule;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.U2SAData;

/**
 * Source name of a message: a service on the channels of the contract, a sensor, actuator or
 * subsystem named by a field, or a channel's only writer.
 *
 * @param key unique per system
 * @param systemId the vehicle
 * @param channel name of the channel
 * @param name name of the service or source; empty for a channel's only writer
 * @param isService whether it is a service's name, which is the same on all channels
 */
public record SourceName(
    String key, String systemId, String channel, String name, boolean isService) {
  private static final String SERVICE_NAME = "serviceName";
  private static final String ONLY_WRITER = "";

  /** Channels on which services report or answer under their own names. */
  private static final Set<Channel<?>> OF_SERVICES =
      Set.of(
          Channels.HEALTH,
          Channels.DISCOVERY,
          Channels.FUNCTIONALITY,
          Channels.CONFIGURATION,
          Channels.MISSION,
          Channels.FENCE_ORDERS);

  /** Fields that name the sources of other channels; empty for channels with one writer. */
  private static final Map<String, String> FIELDS = fields();

  private static Map<String, String> fields() {
    Map<String, String> fields = new HashMap<>();
    OF_SERVICES.forEach(channel -> fields.put(channel.name(), SERVICE_NAME));
    Set.of(
            Channels.SENSED_STATE,
            Channels.SENSED_OBJECTS,
            Channels.SCANS,
            Channels.IMAGES,
            Channels.POWER)
        .forEach(channel -> fields.put(channel.name(), "sensorName"));
    fields.put(Channels.ACTUATORS.name(), "actuatorName");
    fields.put(Channels.CONDITIONS.name(), SERVICE_NAME);
    fields.put(Channels.NAVIGATION.name(), "subsystem");
    fields.put(Channels.PLANS.name(), "subsystem");
    Set.of(
            Channels.STATE,
            Channels.LOCAL_STATE,
            Channels.GOALS,
            Channels.OBJECTS,
            Channels.GRID,
            Channels.FAILSAFE,
            Channels.ARMING_STATE,
            Channels.FENCE,
            Channels.MANUAL_STATE)
        .forEach(channel -> fields.put(channel.name(), ONLY_WRITER));
    return fields;
  }

  /** Source of a message; empty if anyone with permission may publish it, such as queries. */
  public static Optional<SourceName> of(
      Topic topic, AccessRule rule, ByteBuf payload, MessageCodec codec) {
    boolean isReport =
        rule != null
            && (rule.kind() == AccessRule.Kind.REPORT || rule.kind() == AccessRule.Kind.URGENT);
    String field = isReport ? FIELDS.get(topic.channel()) : null;
    if (field == null) {
      return Optional.empty();
    }
    String name =
        field.isEmpty()
            ? ""
            : codec
                .peek(ByteBufUtil.getBytes(payload), field)
                .or(() -> payload.isReadable() ? unset(rule.type(), field) : Optional.empty())
                .orElse(topic.source()); // deleted by an empty message
    boolean isService = OF_SERVICES.contains(rule.channel());
    String kind = isService ? "" : topic.channel(); // never empty
    String key = key(topic.systemId(), kind, name);
    return Optional.of(new SourceName(key, topic.systemId(), topic.channel(), name, isService));
  }

  /** Default of the field, which readers assume for a message without it. */
  private static <M extends U2SAData> Optional<String> unset(MessageType<M> type, String field) {
    return type.field(field).flatMap(each -> each.get(type.create())).map(String::valueOf);
  }

  /**
   * @param kind name of the channel; empty for a service's name
   */
  static String key(String systemId, String kind, String name) {
    return systemId + "/" + kind + "/" + name;
  }

  /** The name of a channel's only writer. */
  static SourceName ofOnlyWriter(String systemId, Channel<?> channel) {
    return new SourceName(key(systemId, channel.name(), ""), systemId, channel.name(), "", false);
  }

  /** Whether it is the name of a channel's only writer. */
  boolean isOfOnlyWriter() {
    return ONLY_WRITER.equals(FIELDS.get(channel));
  }

  boolean isOf(Channel<?> of) {
    return channel.equals(of.name());
  }
}
