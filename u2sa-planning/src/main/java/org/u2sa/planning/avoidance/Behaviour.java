package org.u2sa.planning.avoidance;

import java.util.Optional;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.ArcChooser;

/** State of a {@link GoalAttempt}: the vehicle's current way of reaching its goal. */
sealed interface Behaviour permits Following, Searching, BackingOut {
  ArcChoice choose(ArcChooser arcs, Situation now);

  /** Excludes time in which traffic blocked the vehicle [µs]. */
  void leaveOut(long micros);

  /** Reason for giving up the goal, or empty. */
  Optional<String> givesUp(Situation now);

  /** Whether the vehicle has to free itself; called once a step. */
  default boolean isStuck(Situation now) {
    return false;
  }
}
