package org.u2sa.planning;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.ObjectGoal;
import org.u2sa.planning.avoidance.Avoidance;
import org.u2sa.planning.avoidance.AvoidanceVariables;
import org.u2sa.planning.goals.PursuitTime;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.seen.PlanningPlane;
import org.u2sa.planning.seen.SeenTarget;

/**
 * Moves the vehicle near an object of the world model, and points subsystems at it. Without a State
 * Estimator, objects in the vehicle's frame suffice (thesis 4.3.2).
 */
final class ObjectGoalState implements PlannerState {
  private final Avoidance avoidance;
  private final Supplier<AvoidanceVariables> settings;
  private final PursuitTime time;
  private long unseenSinceMicros = Long.MIN_VALUE;

  /**
   * @param time time against which patience with an unseen object is measured
   */
  ObjectGoalState(Avoidance avoidance, Supplier<AvoidanceVariables> settings, PursuitTime time) {
    this.avoidance = avoidance;
    this.settings = settings;
    this.time = time;
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return ObjectGoal.class;
  }

  @Override
  public boolean needsNoState() {
    return true;
  }

  @Override
  public void enter(Pursuit pursuit) {
    avoidance.begin();
    unseenSinceMicros = Long.MIN_VALUE;
  }

  @Override
  public double distanceM(GoalInformation goal, StateInformation state) {
    return find((ObjectGoal) goal, state).map(SeenTarget::distanceM).orElse(1.0e9);
  }

  private Optional<SeenTarget> find(ObjectGoal goal, StateInformation state) {
    return avoidance.world().nearest(goal.objectType(), state);
  }

  @Override
  public Plan plan(Pursuit pursuit) {
    ObjectGoal goal = (ObjectGoal) pursuit.goal();
    StateInformation state = pursuit.state();
    Vehicle vehicle = Vehicle.of(state).orElseThrow();
    Optional<SeenTarget> seen = find(goal, state);
    if (seen.isEmpty()) {
      return unseen(goal);
    }
    unseenSinceMicros = Long.MIN_VALUE;
    SeenTarget target = seen.get();
    List<NavigationPoint> points = new ArrayList<>();
    for (String subsystem : goal.pointed()) {
      points.add(NavigationPoint.at(vehicle.body(target.ned())).subsystem(subsystem));
    }
    if (target.distanceM() <= goal.within()) {
      String remark = String.format(Locale.ROOT, "reached, %.2f m from it", target.distanceM());
      return new Plan(points, Plan.Progress.COMPLETED, remark);
    }
    Point ned = target.approach(goal.within());
    if (!avoidance.isOn()) {
      NavigationPoint point = NavigationPoint.at(vehicle.body(ned));
      goal.speed().ifPresent(point::speed);
      points.add(0, point);
      return Plan.underWay(points);
    }
    PlanningPlane plane = avoidance.world().plane(state);
    Point at = vehicle.on(plane);
    Point place = plane.point(at.x() + ned.x(), at.y() + ned.y(), at.z() + ned.z());
    Avoidance.Step step =
        avoidance.step(
            vehicle,
            state,
            new Avoidance.Wanted(
                goal.uid(),
                Place.of(plane.frame(), place),
                target.radiusM() + goal.within(),
                OptionalDouble.empty(),
                goal.speed()));
    points.add(0, step.point(vehicle));
    return Plan.unless(step.givenUp(), points);
  }

  /** Stops and waits until the object is in sight. */
  private Plan unseen(ObjectGoal goal) {
    if (unseenSinceMicros == Long.MIN_VALUE) {
      unseenSinceMicros = time.micros();
    }
    long waited = time.micros() - unseenSinceMicros;
    if (waited < settings.get().giveUpMicros()) {
      return Plan.underWay(List.of());
    }
    return new Plan(
        List.of(),
        Plan.Progress.ABANDONED,
        String.format(
            Locale.ROOT,
            "abandoned: no %s was seen for %.0f s",
            goal.objectType(),
            Clock.seconds(waited)));
  }
}
