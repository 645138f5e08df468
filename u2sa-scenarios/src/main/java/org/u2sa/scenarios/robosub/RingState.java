package org.u2sa.scenarios.robosub;

import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;
import org.u2sa.planning.Surroundings;

/** {@link SurfaceInRing}: below the middle of a floating ring at the present depth, then up. */
final class RingState extends SightState {
  private static final double BELOW_M = 0.25; // level distance from the middle
  private static final double SURFACE_M = 0.15;
  private static final double RISE_S = 20.0; // rising without a depth

  private long risingMicros = Long.MIN_VALUE;

  RingState(Surroundings surroundings) {
    super(surroundings);
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return SurfaceInRing.class;
  }

  @Override
  void begin() {
    risingMicros = Long.MIN_VALUE;
  }

  @Override
  Optional<Point> aim(SubTask task, StateInformation state) {
    return task.objectTypes().stream().findFirst().flatMap(type -> nearest(type, state));
  }

  @Override
  Plan approach(SubTask task, StateInformation state, Point way) {
    long now = state.timestamp().orElseThrow();
    if (risingMicros == Long.MIN_VALUE) {
      if (Math.hypot(way.x(), way.y()) > BELOW_M) {
        return to(task, state, Point.of(way.x(), way.y(), 0.0));
      }
      risingMicros = now;
    }
    boolean isUp =
        isStateless(state)
            ? Clock.seconds(now - risingMicros) > RISE_S
            : way.z() > -SURFACE_M;
    return isUp
        ? completed("at the surface")
        : to(task, state, isStateless(state) ? Point.of(0.0, 0.0, -1.0) : way);
  }
}
