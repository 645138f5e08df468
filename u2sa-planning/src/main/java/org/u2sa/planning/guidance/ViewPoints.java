package org.u2sa.planning.guidance;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;

/** Adds {@link Waypoint#lookAt} to a goal's navigation points: for a gimbal, or as heading. */
public final class ViewPoints {
  private static final String VEHICLE = "VEHICLE";
  private static final double OVERHEAD_M = 1.0; // closer points have no meaningful direction

  /** The subsystem that looks. */
  public record Variables(
      @Variable(ifAbsentText = "GIMBAL")
          @Description(
              "Subsystem that looks at the lookAt of goals; VEHICLE turns the vehicle itself, if it can move in any direction.")
          String viewSubsystem) {}

  private final Supplier<Variables> settings;

  public ViewPoints(Supplier<Variables> settings) {
    this.settings = settings;
  }

  /** The points, with the view requested by the goal. */
  public List<NavigationPoint> with(
      List<NavigationPoint> points, GoalInformation goal, StateInformation state) {
    Optional<Point> view = goal instanceof Waypoint at ? at.lookAt() : Optional.empty();
    if (view.isEmpty()) {
      return points;
    }
    Vehicle vehicle = Vehicle.of(state).orElseThrow();
    Point ned = vehicle.nedOf(Place.of(((Waypoint) goal).referenceFrame(), view.get()));
    String subsystem = settings.get().viewSubsystem();
    if (!subsystem.equals(VEHICLE)) {
      List<NavigationPoint> all = new ArrayList<>(points);
      all.add(NavigationPoint.at(vehicle.body(ned)).subsystem(subsystem));
      return all;
    }
    double turn = Leg.wrapped(Math.atan2(ned.y(), ned.x()) - vehicle.headingRad());
    if (Math.hypot(ned.x(), ned.y()) > OVERHEAD_M) {
      points.stream()
          .filter(point -> point.subsystem().equals(VEHICLE) && point.turn().isEmpty())
          .forEach(point -> point.turn(turn));
    }
    return points;
  }
}
