package org.u2sa.scenarios.robosub;

import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;

/** {@link DropMarkers}: hovers above a bin. */
final class BinState extends ReleaseState {
  private static final double ABOVE_M = 0.9; // height above the bin's middle
  private static final double STEADY_M = 0.1; // distance from that position

  BinState(TaskSight sight) {
    super(sight, "DROPPER");
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return DropMarkers.class;
  }

  @Override
  Plan approach(SubTask task, StateInformation state, Point way) {
    Point above = way.minus(Point.of(0.0, 0.0, ABOVE_M));
    return release(above.distance() < STEADY_M, to(task, state, above), state);
  }
}
