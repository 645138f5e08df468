package org.u2sa.core.security;

import static org.u2sa.core.security.AccessRole.CONTROL;
import static org.u2sa.core.security.AccessRole.LAUNCHER;
import static org.u2sa.core.security.AccessRole.MONITOR;
import static org.u2sa.core.security.AccessRole.OPERATOR;
import static org.u2sa.core.security.AccessRole.SAFETY;
import static org.u2sa.core.security.AccessRole.SERVICE;
import static org.u2sa.core.security.AccessRule.Kind.ORDER;
import static org.u2sa.core.security.AccessRule.Kind.QUESTION;
import static org.u2sa.core.security.AccessRule.Kind.REPORT;
import static org.u2sa.core.security.AccessRule.Kind.URGENT;

import java.util.Collections;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.core.security.AccessRule.Kind;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.contract.ConfigurationChangeResult;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationUndo;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.contract.ServiceOrder;
import org.u2sa.messages.contract.ServiceOrderResult;
import org.u2sa.messages.mission.GoalClass;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.mission.MissionRequest;
import org.u2sa.messages.safety.FenceOrder;
import org.u2sa.messages.safety.FenceOrderResult;
import org.u2sa.messages.schema.MessageType;

/**
 * Access control list: message types by channel, and who may publish them; anything not listed is
 * refused. The embedded broker's rules, Mosquitto's and the table in docs/security.md are derived
 * from it.
 */
public final class AccessTable {
  private static final Set<AccessRole> SERVICES =
      EnumSet.of(SERVICE, CONTROL, LAUNCHER, MONITOR, SAFETY);
  private static final Set<AccessRole> ANSWERING =
      EnumSet.of(
          SERVICE, CONTROL, LAUNCHER, MONITOR, SAFETY, OPERATOR); // because its tools are services
  private static final Set<AccessRole> ALL = EnumSet.allOf(AccessRole.class);

  private static final List<AccessRule> RULES =
      List.of(
          row(Channels.SENSED_STATE, REPORT, SERVICES),
          row(Channels.STATE, REPORT, SERVICES),
          row(Channels.LOCAL_STATE, REPORT, SERVICES),
          row(Channels.SENSED_OBJECTS, REPORT, SERVICES),
          row(Channels.SCANS, REPORT, SERVICES),
          row(Channels.IMAGES, REPORT, SERVICES),
          row(Channels.OBJECTS, REPORT, SERVICES),
          row(Channels.GRID, REPORT, SERVICES),
          row(Channels.GOALS, REPORT, SERVICES),
          row(Channels.GOAL_REPORTS, REPORT, SERVICES),
          row(Channels.GOAL_UPDATES, REPORT, ANSWERING),
          row(Channels.GOAL_COMMANDS, ORDER, Set.of(OPERATOR)),
          row(Channels.MISSION, MissionRequest.TYPE, QUESTION, ALL),
          row(Channels.MISSION, GoalClass.TYPE, REPORT, SERVICES),
          row(Channels.MISSION, MissionReport.TYPE, REPORT, SERVICES),
          row(Channels.MISSION, MissionOrder.TYPE, ORDER, Set.of(OPERATOR)),
          row(Channels.MISSION, MissionOrderResult.TYPE, REPORT, SERVICES),
          row(Channels.NAVIGATION, REPORT, SERVICES),
          row(Channels.PLANS, REPORT, SERVICES),
          row(Channels.ACTUATION, REPORT, Set.of(CONTROL)),
          row(Channels.ACTUATORS, REPORT, SERVICES),
          row(Channels.DISCOVERY, DiscoveryRequest.TYPE, QUESTION, ALL),
          row(Channels.DISCOVERY, DiscoveryResponse.TYPE, REPORT, ANSWERING),
          row(Channels.FUNCTIONALITY, FunctionalityRequest.TYPE, QUESTION, ALL),
          row(Channels.FUNCTIONALITY, FunctionalityResponse.TYPE, REPORT, ANSWERING),
          row(Channels.STOP, URGENT, Set.of(OPERATOR)),
          row(Channels.CONFIGURATION, ConfigurationRequest.TYPE, QUESTION, ALL),
          row(Channels.CONFIGURATION, ConfigurationResponse.TYPE, REPORT, ANSWERING),
          row(Channels.CONFIGURATION, ConfigurationChange.TYPE, ORDER, Set.of(OPERATOR)),
          row(Channels.CONFIGURATION, ConfigurationChangeResult.TYPE, REPORT, ANSWERING),
          row(Channels.CONFIGURATION, ConfigurationTransaction.TYPE, ORDER, Set.of(OPERATOR)),
          row(Channels.CONFIGURATION, ConfigurationUndo.TYPE, ORDER, Set.of(OPERATOR)),
          row(Channels.CONFIGURATION, ConfigurationTransactionResult.TYPE, REPORT, ANSWERING),
          row(Channels.HEALTH, REPORT, ANSWERING).asWill(),
          row(Channels.CONDITIONS, REPORT, Set.of(MONITOR)),
          row(Channels.SERVICE_ORDERS, ServiceOrder.TYPE, ORDER, Set.of(MONITOR, OPERATOR)),
          row(Channels.SERVICE_ORDERS, ServiceOrderResult.TYPE, REPORT, Set.of(LAUNCHER)),
          // If a clear did not lift a stop, actuators repeat it only within their own process: an
          // account that can stop a vehicle in the air would need guarding, and the Safety Manager
          // repeats it.
          row(Channels.EMERGENCY_STOP, URGENT, Set.of(SAFETY, OPERATOR)).asWill(),
          row(Channels.FAILSAFE, URGENT, Set.of(MONITOR, SAFETY)),
          row(Channels.OPERATOR, REPORT, Set.of(OPERATOR)),
          row(Channels.ARMING, URGENT, Set.of(OPERATOR)),
          row(Channels.ARMING_STATE, URGENT, Set.of(SAFETY)),
          row(Channels.FENCE, REPORT, Set.of(SAFETY)),
          row(Channels.FENCE_ORDERS, FenceOrder.TYPE, ORDER, Set.of(OPERATOR)),
          row(Channels.FENCE_ORDERS, FenceOrderResult.TYPE, REPORT, Set.of(SAFETY)),
          row(Channels.MANUAL_ORDERS, ORDER, Set.of(OPERATOR)),
          row(Channels.MANUAL_STATE, REPORT, Set.of(CONTROL)),
          row(Channels.MANUAL_DRIVE, REPORT, Set.of(OPERATOR)),
          row(Channels.POWER, REPORT, SERVICES),
          row(Channels.GROUND_PRESSURE, REPORT, Set.of(OPERATOR)));

  private static final Map<String, Map<String, AccessRule>> BY_CHANNEL = byChannel();

  private AccessTable() {}

  /** All rows, in the order of {@link Channels#all}. */
  public static List<AccessRule> all() {
    return RULES;
  }

  private static AccessRule row(Channel<?> channel, Kind kind, Set<AccessRole> roles) {
    return row(channel, channel.type(), kind, roles);
  }

  private static AccessRule row(
      Channel<?> channel, MessageType<?> type, Kind kind, Set<AccessRole> roles) {
    return new AccessRule(channel, type, roles, kind, false);
  }

  private static Map<String, Map<String, AccessRule>> byChannel() {
    Map<String, Map<String, AccessRule>> table = new HashMap<>();
    for (AccessRule rule : RULES) {
      table
          .computeIfAbsent(rule.channel().name(), name -> new HashMap<>())
          .put(rule.type().name(), rule);
    }
    return table;
  }

  /**
   * Rule for a message: by its type, or its nearest ancestor type with a rule.
   *
   * @param channel a standard channel's name
   * @param known type under which the message will be read, {@link
   *     org.u2sa.messages.schema.MessageTypes#nearest(List)}
   */
  public static Optional<AccessRule> rule(String channel, MessageType<?> known) {
    Map<String, AccessRule> ofChannel = BY_CHANNEL.getOrDefault(channel, Map.of());
    for (MessageType<?> type = known; type != null; type = type.parent().orElse(null)) {
      AccessRule rule = ofChannel.get(type.name());
      if (rule != null && rule.type() == type) {
        return Optional.of(rule);
      }
    }
    return Optional.empty();
  }

  /**
   * Whether one of the roles may publish the message on a non-standard channel: only what the role
   * may publish on the message's own channel.
   */
  public static boolean mayPublishOnOwnChannel(Set<AccessRole> roles, MessageType<?> known) {
    if (roles.stream().noneMatch(AccessRole::mayPublishOnOwnChannels)) {
      return false;
    }
    boolean standard = false;
    for (AccessRule rule : RULES) {
      if (rule.type().messageClass().isAssignableFrom(known.messageClass())) {
        standard = true;
        if (!Collections.disjoint(rule.roles(), roles)) {
          return true;
        }
      }
    }
    return !standard;
  }
}
