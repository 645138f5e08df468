package org.u2sa.scenarios.roboboat.subvehicle;

import java.util.List;
import java.util.Locale;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;
import org.u2sa.planning.PlannerState;
import org.u2sa.planning.Pursuit;

/**
 * The carrier's part of a {@link FetchGoal}: presses the bow against the dock while the sub-vehicle
 * is away, so that wind and current do not carry the boat off. The sub-vehicle's report ends the
 * goal; without one, the carrier gives up.
 */
final class AwaitState implements PlannerState {
  private static final double BEYOND_LIMIT_S = 40.0; // time for start-up, return and landing

  private static final double PRESSES_M = 0.5;
  private static final double PRESSES_MPS = 0.3; // speed commanded against the wall

  private long beganMicros;

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return FetchGoal.class;
  }

  @Override
  public double distanceM(GoalInformation goal, StateInformation state) {
    return 0.0;
  }

  @Override
  public void enter(Pursuit pursuit) {
    beganMicros = pursuit.state().timestamp().orElseThrow();
  }

  @Override
  public Plan plan(Pursuit pursuit) {
    double waitedS = Clock.seconds(pursuit.state().timestamp().orElseThrow() - beganMicros);
    if (waitedS > ((FetchGoal) pursuit.goal()).limit() + BEYOND_LIMIT_S) {
      return new Plan(
          List.of(),
          Plan.Progress.ABANDONED,
          String.format(
              Locale.ROOT, "given up: no report from the sub-vehicle for %.0f s", waitedS));
    }
    NavigationPoint against = NavigationPoint.at(Point.of(PRESSES_M, 0.0, 0.0));
    return Plan.underWay(List.of(against.speed(PRESSES_MPS).turn(0.0)));
  }
}
