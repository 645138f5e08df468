package org.u2sa.core.safety;

import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.schema.U2SAData;

/** Watches for one hazard, on the Safety Manager's thread. */
interface Watch {
  /**
   * What the standard watches hear. Arming state and failsafe are those of the Safety Manager
   * before this one.
   */
  List<Channel<?>> STANDARD =
      List.of(
          Channels.STATE,
          Channels.CONDITIONS,
          Channels.HEALTH,
          Channels.OPERATOR,
          Channels.POWER,
          Channels.ACTUATORS,
          Channels.GOALS,
          Channels.ARMING_STATE,
          Channels.FAILSAFE);

  Hazard hazard();

  /** Whether it takes note of messages of the channel. */
  default boolean hears(Channel<?> channel) {
    return STANDARD.contains(channel);
  }

  /** Takes note of a message. */
  default void see(U2SAData message, long nowMicros) {}

  /** What is wrong now, in words; empty if nothing is. */
  Optional<String> trouble(long nowMicros);

  /** What speaks against arming, in words; empty if nothing does. */
  default Optional<String> objection(long nowMicros) {
    return trouble(nowMicros);
  }
}
