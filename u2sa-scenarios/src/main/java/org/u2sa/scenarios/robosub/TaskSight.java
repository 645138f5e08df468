package org.u2sa.scenarios.robosub;

import org.u2sa.planning.PlannerView;

/** What the states of all goals see, and when one of them last saw what it goes to. */
final class TaskSight {
  final PlannerView surroundings;
  private long lastMicros = Long.MIN_VALUE; // until the first step

  TaskSight(PlannerView surroundings) {
    this.surroundings = surroundings;
  }

  /** Time of the last sighting [µs]; the first step counts as one. */
  long lastMicros(boolean isSeen, long nowMicros) {
    lastMicros = isSeen || lastMicros == Long.MIN_VALUE ? nowMicros : lastMicros;
    return lastMicros;
  }
}
