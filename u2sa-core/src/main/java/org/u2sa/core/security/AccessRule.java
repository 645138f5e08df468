package org.u2sa.core.security;

import java.util.Set;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.schema.MessageType;

/**
 * One row of {@link AccessTable}: a type on the channel that carries it. Retained or not, QoS and
 * urgency are the channel's.
 *
 * @param channel a standard channel
 * @param type the type; its subclasses go by the same rule
 * @param roles who may publish it
 * @param kind how much of it one client may send
 * @param mayBeWill whether it may be a client's MQTT will, which the broker publishes for it
 */
public record AccessRule(
    Channel<?> channel, MessageType<?> type, Set<AccessRole> roles, Kind kind, boolean mayBeWill) {
  /** What a message asks of those who receive it. */
  public enum Kind {
    /** Reports: measurements, states, plans, answers. */
    REPORT,
    /** Asks every service for an answer and changes nothing. */
    QUESTION,
    /** Changes configuration, services or goals. */
    ORDER,
    /** Stops, arms or restrains the vehicle: takes precedence, with reserved room. */
    URGENT
  }

  private static final int LONGEST_QUESTION = 4 * 1_024; // names a service or none
  private static final int LONGEST_URGENT = 16 * 1_024;
  private static final int LONGEST_CHANGE = 64 * 1_024; // 256 variables, the most of one change

  public AccessRule {
    roles = Set.copyOf(roles);
  }

  AccessRule asWill() {
    return new AccessRule(channel, type, roles, kind, true);
  }

  /** Whether a broker keeps the last one for late subscribers. */
  public boolean retained() {
    return channel.isRetained();
  }

  /**
   * The longest payload [bytes]. Every service reads all questions and configuration changes, its
   * own or not, between states and commands: long ones would delay those.
   */
  public int longestPayload() {
    switch (kind) {
      case QUESTION:
        return LONGEST_QUESTION;
      case URGENT:
        return LONGEST_URGENT;
      case ORDER:
        return channel.equals(Channels.CONFIGURATION) ? LONGEST_CHANGE : Integer.MAX_VALUE;
      default:
        return Integer.MAX_VALUE;
    }
  }

  /** MQTT's quality of service: 1 where each message matters. */
  public int quality() {
    return channel.deliversEvery() || channel.isRetained() ? 1 : 0;
  }
}
