package org.u2sa.scenarios.robosub;

import java.util.Locale;
import java.util.Optional;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;
import org.u2sa.planning.PlannerView;

/**
 * {@link HomeOnPinger}: at the depth of the start until the pinger is straight below. Its direction
 * suffices, with or without its distance.
 */
final class PingerState extends SightState {
  private static final double ABOVE_M = 0.3; // level distance that counts as above it
  private static final double SLOPE = 0.12; // or the level distance per height: 7 degrees

  private Optional<Double> downM = Optional.empty(); // depth to keep, on the planner's plane

  PingerState(PlannerView surroundings) {
    super(surroundings);
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return HomeOnPinger.class;
  }

  @Override
  void begin() {
    downM = Optional.empty();
  }

  @Override
  Optional<Point> aim(SubTask task, StateInformation state) {
    return task.objectTypes().stream().findFirst().flatMap(type -> nearest(type, state));
  }

  @Override
  Plan approach(SubTask task, StateInformation state, Point way) {
    double hereM = surroundings.here(state).z();
    double keptM = downM.orElse(hereM);
    downM = Optional.of(keptM);
    double levelM = Math.hypot(way.x(), way.y());
    if (levelM < Math.max(ABOVE_M, SLOPE * way.z())) {
      double slopeRad = Math.atan2(levelM, way.z());
      return completed(
          String.format(Locale.ROOT, "above it, within %.1f deg", Math.toDegrees(slopeRad)));
    }
    return to(task, state, Point.of(way.x(), way.y(), keptM - hereM));
  }
}
