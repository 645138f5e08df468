package org.u2sa.planning.avoidance;

import java.util.Optional;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.ArcChooser;

/** What the vehicle does to reach its goal: one state of a {@link GoalAttempt}. */
interface Behaviour {
  /** Chooses the motion of this step. */
  ArcChoice choose(ArcChooser arcs, Situation now);

  /** Excludes time in which traffic held the vehicle up [µs]. */
  void leaveOut(long micros);

  /** Reason for giving up the goal, or empty. */
  Optional<String> givesUp(Situation now);

  /** Whether the vehicle has to free itself; called once a step. */
  boolean isStuck(Situation now);
}
