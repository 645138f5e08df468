package org.u2sa.core.security;

import java.util.Set;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.schema.MessageType;

/**
 * One row of {@link AccessTable}: a type on the channel that carries it. Retention, QoS and urgency
 * are defined by the channel.
 *
 * @param channel a standard channel
 * @param type message type; the rule includes its subclasses
 * @param roles roles that may publish it
 * @param kind class of message, which limits its rate per client
 * @param mayBeWill whether it may be a client's MQTT will message
 */
public record AccessRule(
    Channel<?> channel, MessageType<?> type, Set<AccessRole> roles, Kind kind, boolean mayBeWill) {
  /** What a message demands of its receivers. */
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

  private static final int LONGEST_QUESTION = 4 * 1_024; // a query contains at most a service name
  private static final int LONGEST_URGENT = 16 * 1_024;
  private static final int LONGEST_CHANGE = 64 * 1_024; // 256 variables, the maximum per change

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
   * Maximum payload [bytes]. Every service receives all queries and configuration changes, even
   * those for others; long ones would delay states and commands.
   */
  public int longestPayload() {
    return switch (kind) {
      case QUESTION -> LONGEST_QUESTION;
      case URGENT -> LONGEST_URGENT;
      case ORDER -> channel.equals(Channels.CONFIGURATION) ? LONGEST_CHANGE : Integer.MAX_VALUE;
      case REPORT -> Integer.MAX_VALUE;
    };
  }

  /** MQTT quality of service: 1 where no message may be lost. */
  public int quality() {
    return channel.deliversEvery() || channel.isRetained() ? 1 : 0;
  }
}
