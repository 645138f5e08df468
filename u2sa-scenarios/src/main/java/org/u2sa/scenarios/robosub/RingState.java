package org.u2sa.scenarios.robosub;

import java.util.Comparator;
import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;

/** {@link SurfaceInRing}: goes well below the middle of a floating ring, then surfaces. */
final class RingState extends SightState {
  private static final double BELOW_M = 0.25; // level distance from the middle
  private static final double DEPTH_M = 1.5; // below the ring on the way there
  private static final double CLIMB_M = 0.3; // climbs vertically if deeper than this
  private static final double ABOVE_M =
      1.0; // roughly known ring height: rise until the depth stops changing
  private static final double STEP_M = 0.05; // smaller rises are ignored
  private static final double AT_TOP_S = 3.0; // without a rise

  private boolean isRising;
  private double highestDownM;
  private long highestMicros;

  RingState(TaskSight sight) {
    super(sight);
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return SurfaceInRing.class;
  }

  @Override
  void begin() {
    isRising = false;
  }

  /** The nearest ring: after homing on a pinger, the one above it. */
  @Override
  Optional<Point> aim(SubTask task, StateInformation state) {
    Point here = surroundings.here(state);
    return task.objectTypes().stream()
        .limit(1)
        .flatMap(type -> places(type, state))
        .min(Comparator.comparingDouble(place -> place.minus(here).distance()));
  }

  @Override
  Plan approach(SubTask task, StateInformation state, Point way) {
    if (!isRising) {
      double upM = way.z() + DEPTH_M; // down to that depth
      if (upM < -CLIMB_M) {
        return to(task, state, Point.of(0.0, 0.0, upM)); // to clear obstacles
      }
      if (Math.hypot(way.x(), way.y()) > BELOW_M) {
        return to(task, state, Point.of(way.x(), way.y(), upM));
      }
      isRising = true;
      highestDownM = Double.POSITIVE_INFINITY;
    }
    double downM = -way.z(); // below the ring
    long now = state.timestamp().orElseThrow();
    if (downM < highestDownM - STEP_M) {
      highestDownM = downM;
      highestMicros = now;
    }
    return Clock.seconds(now - highestMicros) > AT_TOP_S
        ? completed("at the surface")
        : to(task, state, Point.of(way.x(), way.y(), way.z() - ABOVE_M));
  }
}
