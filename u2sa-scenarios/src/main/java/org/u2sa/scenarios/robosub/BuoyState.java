package org.u2sa.scenarios.robosub;

import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;

/** {@link BumpBuoy}: straight into a buoy. */
final class BuoyState extends SightState {
  private static final double TOUCHED_M = 0.25; // distance of centres when hulls overlap

  BuoyState(TaskSight sight) {
    super(sight);
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return BumpBuoy.class;
  }

  @Override
  Plan approach(SubTask task, StateInformation state, Point way) {
    double distance = way.distance();
    if (distance < TOUCHED_M) {
      return completed("bumped");
    }
    return to(task, state, way.times((distance + 1.0) / distance));
  }
}
