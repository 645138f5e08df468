package org.u2sa.scenarios.robosub;

import java.util.Optional;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;

/** {@link ShootTorpedoes}: moves in front of a hoop, at its depth, heading for its middle. */
final class TorpedoState extends ReleaseState {
  private static final double BEFORE_M = 1.3; // place on the hoop's normal to shoot from
  private static final double THERE_M = 0.2;
  private static final double LEVEL_M = 0.07;
  private static final double AIMED_RAD = 0.03;

  private Optional<Point> normal = Optional.empty(); // level unit vector through the hoop
  private boolean isThere;

  TorpedoState(TaskSight sight) {
    super(sight, "LAUNCHER");
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return ShootTorpedoes.class;
  }

  @Override
  void begin() {
    super.begin();
    normal = Optional.empty();
    isThere = false;
  }

  @Override
  Plan approach(SubTask task, StateInformation state, Point way) {
    Point side = normal.orElse(way); // stays on the side of the approach
    normal = axis(task, state).map(along -> towards(along, side)).or(() -> normal);
    Point place = way.minus(normal.orElse(way).times(BEFORE_M));
    isThere |= place.distance() < THERE_M;
    Plan holding = to(task, state, place);
    if (!isThere) {
      return holding;
    }
    double turn = turnTo(way, state);
    holding.points().forEach(point -> point.turn(turn));
    boolean isAimed =
        Math.abs(turn) < AIMED_RAD
            && Math.abs(state.theta().orElse(0.0)) < AIMED_RAD
            && Math.abs(way.z()) < LEVEL_M
            && place.distance() < 2.0 * THERE_M;
    return release(isAimed, holding, state);
  }
}
