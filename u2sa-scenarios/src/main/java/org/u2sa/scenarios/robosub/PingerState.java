package org.u2sa.scenarios.robosub;

import java.util.Locale;
import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;

/**
 * {@link HomeOnPinger}: rises slightly, then moves horizontally until the pinger is directly below.
 * Only its direction is needed, not its distance.
 */
final class PingerState extends SightState {
  private static final double CLIMB_S = 4.0; // initial climb, to clear obstacles
  private static final double CLIMB_M = 2.0; // far enough for full speed
  private static final double ABOVE_M = 0.3; // horizontal distance that counts as above the pinger
  private static final double SLOPE = 0.12; // or horizontal distance per height: 7 degrees

  private long enteredMicros;
  private Optional<Double> downM = Optional.empty(); // depth to keep, on the planner's plane

  PingerState(TaskSight sight) {
    super(sight);
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return HomeOnPinger.class;
  }

  @Override
  void begin() {
    downM = Optional.empty();
    enteredMicros = Long.MIN_VALUE;
  }

  @Override
  Plan approach(SubTask task, StateInformation state, Point way) {
    long now = state.timestamp().orElseThrow();
    enteredMicros = enteredMicros == Long.MIN_VALUE ? now : enteredMicros;
    if (Clock.seconds(now - enteredMicros) < CLIMB_S) {
      return to(task, state, Point.of(0.0, 0.0, -CLIMB_M));
    }
    double hereM = surroundings.here(state).z();
    double keptM = downM.orElse(hereM);
    downM = Optional.of(keptM);
    double levelM = Math.hypot(way.x(), way.y());
    if (levelM < Math.max(ABOVE_M, SLOPE * way.z())) {
      double slopeRad = Math.atan2(levelM, way.z());
      return completed(
          String.format(Locale.ROOT, "above pinger, within %.1f deg", Math.toDegrees(slopeRad)));
    }
    return to(task, state, Point.of(way.x(), way.y(), keptM - hereM));
  }
}
