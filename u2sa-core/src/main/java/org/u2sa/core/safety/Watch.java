package org.u2sa.core.safety;

import java.util.Optional;
import org.u2sa.messages.schema.U2SAData;

/** Watches for one hazard, on the Safety Manager's thread. */
interface Watch {
  Hazard hazard();

  /** Takes note of a message of any kind. */
  default void see(U2SAData message, long nowMicros) {}

  /** What is wrong now, in words; empty if nothing is. */
  Optional<String> trouble(long nowMicros);

  /** What speaks against arming, in words; empty if nothing does. */
  default Optional<String> objection(long nowMicros) {
    return trouble(nowMicros);
  }
}
