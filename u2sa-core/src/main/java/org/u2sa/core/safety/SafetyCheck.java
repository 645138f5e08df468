package org.u2sa.core.safety;

import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.contract.FailsafeAction;
import org.u2sa.messages.schema.U2SAData;

/**
 * A custom check in the Safety Manager, such as for water in the hull: it prevents arming, and in
 * motion it is a cause in the failsafe matrix. All methods are called on the Safety Manager's
 * thread and return at once. A check that throws counts as trouble.
 */
public interface SafetyCheck {
  /**
   * Name of the hazard, in lower case, such as {@code leak}: the word in causes and reasons, and
   * the name of its variable in the failsafe matrix, ON LEAK. Unique.
   */
  String name();

  /** The matrix's default for it. */
  FailsafeAction defaultAction();

  /**
   * The channels that it hears; any but arming and emergency-stop, which the Safety Manager keeps
   * to itself.
   */
  Set<Channel<?>> channels();

  /**
   * Handles a message on one of its channels.
   *
   * @param nowMicros time of the run's clock [µs]
   */
  void see(U2SAData message, long nowMicros);

  /** Present trouble in words, such as {@code 2 cm of water}; empty if none. */
  Optional<String> trouble(long nowMicros);

  /** Reason against arming, in words; by default the trouble. */
  default Optional<String> objection(long nowMicros) {
    return trouble(nowMicros);
  }
}
