package {{package}};

import java.util.Collection;
import java.util.List;
import java.util.Locale;
import org.u2sa.planning.Plan;
import org.u2sa.planning.PlannerState;
import org.u2sa.planning.PlannerStateProvider;
import org.u2sa.planning.PlannerView;
import org.u2sa.planning.Pursuit;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/** Goes straight to waypoints, and slowly near them. A state of the path planner. */
public final class {{Name}} implements PlannerState {
  private record Variables(
      @Variable(unit = "m", min = 0, max = 100, ifAbsent = 2)
          @Description("Distance to a waypoint within which the vehicle slows down.")
          double slowWithin,
      @Variable(unit = "m/s", min = 0.01, max = 20, ifAbsent = 0.5)
          @Description("Speed near a waypoint.")
          double slowSpeed) {}

  private final Settings<Variables> tuning;

  /** The planner's configuration has the variables. */
  {{Name}}(Configurator planner) {
    tuning = planner.settings(Variables.class);
  }

  /** Brings it to every path planner; named in META-INF/services. */
  public static final class Provider implements PlannerStateProvider {
    @Override
    public Collection<PlannerState> plannerStates(Configurator planner, PlannerView surroundings) {
      return List.of(new {{Name}}(planner));
    }
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return Waypoint.class;
  }

  @Override
  public void enter(Pursuit pursuit) {
    // stateless between waypoints
  }

  @Override
  public double distanceM(GoalInformation goal, StateInformation state) {
    Point ahead = towards((Waypoint) goal, state).point();
    return Math.hypot(ahead.x(), ahead.y());
  }

  @Override
  public Plan plan(Pursuit pursuit) {
    Waypoint waypoint = (Waypoint) pursuit.goal();
    NavigationPoint point = towards(waypoint, pursuit.state());
    double distance = distanceM(waypoint, pursuit.state());
    if (distance <= waypoint.horizontalThreshold()) {
      String remark = String.format(Locale.ROOT, "reached, %.2f m away", distance);
      return new Plan(List.of(point), Plan.Progress.COMPLETED, remark);
    }
    waypoint.speed().ifPresent(point::speed);
    if (distance < tuning.get().slowWithin()) {
      point.speed(tuning.get().slowSpeed());
    }
    return Plan.underWay(List.of(point));
  }

  /**
   * The waypoint as the vehicle sees it; a coordinate that does not matter is the vehicle's own.
   */
  private static NavigationPoint towards(Waypoint waypoint, StateInformation state) {
    StateInformation vehicle = state.in(waypoint.referenceFrame());
    double x = waypoint.x().orElse(vehicle.x().orElseThrow());
    double y = waypoint.y().orElse(vehicle.y().orElseThrow());
    double z = waypoint.z().orElse(vehicle.z().orElse(0.0));
    return NavigationPoint.at(Point.of(x, y, z))
        .referenceFrame(waypoint.referenceFrame())
        .in(ReferenceFrame.BODY, vehicle);
  }
}
