package org.u2sa.core.safety;

import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.schema.U2SAData;

/**
 * A custom check in the Safety Manager, such as for water in the hull: it prevents arming, and in
 * motion it is a cause in the failsafe matrix. All methods are called on the Safety Manager's
 * thread and must not block. A check that throws counts as trouble.
 */
public interface SafetyCheck {
  /**
   * Name of the hazard, in lower case, such as {@code leak}: used in causes and reasons, and in its
   * variable in the failsafe matrix (ON LEAK). Unique.
   */
  String name();

  /** Default action in the matrix. */
  FailsafeAction defaultAction();

  /**
   * Channels it receives; any except arming and emergency-stop, which are reserved for the Safety
   * Manager.
   */
  Set<Channel<?>> channels();

  /**
   * Handles a message on one of its channels.
   *
   * @param nowMicros time of the run's clock [µs]
   */
  void see(U2SAData message, long nowMicros);

  /** Current trouble in words, such as {@code 2 cm of water}; empty if none. */
  Optional<String> trouble(long nowMicros);

  /** Reason not to arm, in words; by default the trouble. */
  default Optional<String> objection(long nowMicros) {
    return trouble(nowMicros);
  }
}
