package org.u2sa.scenarios.robosub;

import org.u2sa.planning.PlannerView;

/** The objects that all goal states see, and the time of the last sighting of a target. */
final class TaskSight {
  final PlannerView surroundings;
  private long lastMicros = Long.MIN_VALUE; // MIN_VALUE until the first step

  TaskSight(PlannerView surroundings) {
    this.surroundings = surroundings;
  }

  /** Time of the last sighting [µs]; the first step counts as one. */
  long lastMicros(boolean isSeen, long nowMicros) {
    lastMicros = isSeen || lastMicros == Long.MIN_VALUE ? nowMicros : lastMicros;
    return lastMicros;
  }
}
