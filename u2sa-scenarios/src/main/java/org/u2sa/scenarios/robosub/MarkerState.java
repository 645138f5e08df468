package org.u2sa.scenarios.robosub;

import java.util.Locale;
import java.util.Optional;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;

/** {@link FollowMarker}: goes above a path marker, then follows its direction. */
final class MarkerState extends SightState {
  private static final double ABOVE_M = 0.3; // level distance from the marker
  private static final double ALONG_M =
      1.2; // distance along the marker after which its direction counts as followed
  private static final double FACING_RAD = 0.2;
  private static final double AHEAD_M = 1.0; // look-ahead along the axis

  private Optional<Point> came = Optional.empty(); // horizontal, to the marker when first seen
  private Optional<Point> axis = Optional.empty(); // level unit vector, once above it

  MarkerState(TaskSight sight) {
    super(sight);
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return FollowMarker.class;
  }

  @Override
  void begin() {
    came = Optional.empty();
    axis = Optional.empty();
  }

  @Override
  Plan approach(SubTask task, StateInformation state, Point way) {
    Point ahead =
        Point.of(1.0, 0.0, 0.0); // without a state, the vehicle faces its direction of motion
    came = came.or(() -> Optional.of(state.referenceFrame().isLocal() ? ahead : way));
    boolean isAbove = axis.isPresent() || Math.hypot(way.x(), way.y()) < ABOVE_M;
    if (isAbove && (axis.isEmpty() || state.referenceFrame().isLocal())) {
      Point side = axis.orElse(came.get()); // without a state, both vectors turn with the vehicle
      axis = axis(task, state).map(along -> towards(along, side)).or(() -> axis);
    }
    if (axis.isEmpty()) {
      return to(task, state, Point.of(way.x(), way.y(), 0.0));
    }
    Point along = axis.get();
    double passedM = -(along.x() * way.x() + along.y() * way.y());
    if (passedM > ALONG_M && Math.abs(turnTo(along, state)) < FACING_RAD) {
      return completed(
          String.format(
              Locale.ROOT,
              "followed, towards %.0f deg",
              Math.toDegrees(Math.atan2(along.y(), along.x()))));
    }
    Point target = Point.of(way.x(), way.y(), 0.0).plus(along.times(passedM + AHEAD_M));
    return to(task, state, target);
  }
}
