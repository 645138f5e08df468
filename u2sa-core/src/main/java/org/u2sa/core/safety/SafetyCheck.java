package org.u2sa.core.safety;

import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.contract.FailsafeAction;
import org.u2sa.messages.schema.U2SAData;

/**
 * A check of your own in the Safety Manager, such as for water in the hull: it speaks against
 * arming, and in motion it is a cause in the failsafe matrix. All methods are called on the Safety
 * Manager's thread and return at once. A check that throws counts as trouble.
 */
public interface SafetyCheck {
  /**
   * What it looks out for, in lower case, such as {@code leak}: the word in causes and reasons, and
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
   * Takes note of a message of one of its channels.
   *
   * @param nowMicros time of the run's clock [µs]
   */
  void see(U2SAData message, long nowMicros);

  /** What is wrong now, in words, such as {@code 2 cm of water}; empty if nothing is. */
  Optional<String> trouble(long nowMicros);

  /** What speaks against arming, in words; unless it says otherwise, the trouble. */
  default Optional<String> objection(long nowMicros) {
    return trouble(nowMicros);
  }
}
