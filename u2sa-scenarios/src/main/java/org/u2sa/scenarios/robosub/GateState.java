package org.u2sa.scenarios.robosub;

import java.util.Locale;
import java.util.Optional;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;

/** {@link PassGate}: passes midway between two poles and continues (thesis 4.3.1.3). */
final class GateState extends SightState {
  private static final double BEFORE_M =
      2.0; // distance of the place on the gate's axis to approach first
  private static final double ON_AXIS_M = 0.3;
  private static final double BEYOND_M = 1.0;
  private static final double AHEAD_M = 1.2; // look-ahead along the axis

  private Optional<Point> axis = Optional.empty(); // level unit vector through the gate
  private boolean isThrough;

  GateState(TaskSight sight) {
    super(sight);
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return PassGate.class;
  }

  @Override
  void begin() {
    axis = Optional.empty();
    isThrough = false;
  }

  @Override
  int typesNeeded() {
    return 2;
  }

  @Override
  Optional<Point> aim(SubTask task, StateInformation state) {
    if (task.objectTypes().size() < typesNeeded()) {
      return Optional.empty();
    }
    Optional<Point> first = place(task.objectTypes().get(0), state);
    Optional<Point> second = place(task.objectTypes().get(1), state);
    if (first.isEmpty() || second.isEmpty()) {
      return Optional.empty();
    }
    Point middle = first.get().plus(second.get()).times(0.5);
    Point across = second.get().minus(first.get());
    double width = Math.hypot(across.x(), across.y());
    Point way = middle.minus(surroundings.here(state));
    Point through = Point.of(-across.y() / width, across.x() / width, 0.0);
    boolean isAhead = through.x() * way.x() + through.y() * way.y() > 0.0;
    // Without a state the plane turns with the vehicle, so the axis is recomputed each time.
    boolean isSame =
        axis.map(old -> old.x() * through.x() + old.y() * through.y() > 0.0).orElse(isAhead);
    axis = Optional.of(isSame ? through : through.times(-1.0));
    return Optional.of(middle);
  }

  @Override
  Plan approach(SubTask task, StateInformation state, Point way) {
    Point through = axis.orElse(Point.of(1.0, 0.0, 0.0));
    double along = through.x() * way.x() + through.y() * way.y();
    double aside = through.x() * way.y() - through.y() * way.x();
    if (along < -BEYOND_M) {
      return completed(String.format(Locale.ROOT, "passed, %.2f m from its middle", aside));
    }
    isThrough |= along < BEFORE_M && Math.abs(aside) < ON_AXIS_M;
    isThrough |= along < 0.5;
    Point target =
        isThrough
            ? way.plus(through.times(AHEAD_M - along))
            : way.plus(through.times(-0.7 * BEFORE_M));
    return to(task, state, target);
  }
}
