package org.u2sa.core.safety;

import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;

/** Watches for one hazard, on the Safety Manager's thread. */
interface Watch {
  /**
   * Channels of the standard watches. Arming state and failsafe are those of the previous Safety
   * Manager.
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

  /** Whether this watch handles messages on the channel. */
  default boolean hears(Channel<?> channel) {
    return STANDARD.contains(channel);
  }

  /** Handles a message. */
  default void see(U2SAData message, long nowMicros) {}

  /** Called while a pilot, who counts as an operator, flies by radio. */
  default void pilotFlies(long nowMicros) {}

  /** Saves the watch's state for a successor, so that it detects the same faults. */
  default void handOver(HandOver state, long nowMicros) {}

  /**
   * Restores the state written by {@link #handOver}.
   *
   * @param upToDate true at a swap, where the state was just written; false at a restart, where it
   *     dates from the last change
   */
  default void takeOver(HandOver state, long nowMicros, boolean upToDate) {}

  /** The part of the state that must be saved whenever it changes. */
  default String saved() {
    return "";
  }

  /** Current trouble in words; empty if none. */
  Optional<String> trouble(long nowMicros);

  /** Reason not to arm, in words; empty if none. */
  default Optional<String> objection(long nowMicros) {
    return trouble(nowMicros);
  }
}
