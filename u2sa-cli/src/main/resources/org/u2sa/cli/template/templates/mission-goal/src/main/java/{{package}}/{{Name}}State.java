package {{package}};

import java.util.List;
import java.util.OptionalLong;
import org.u2sa.planning.Plan;
import org.u2sa.planning.PlannerState;
import org.u2sa.planning.Pursuit;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Pursues a {@link {{Name}}}: goes there and stops until the time has elapsed. A state of the path
 * planner.
 */
final class {{Name}}State implements PlannerState {
  private OptionalLong arrivedMicros = OptionalLong.empty();

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return {{Name}}.class;
  }

  @Override
  public void enter(Pursuit pursuit) {
    arrivedMicros = OptionalLong.empty();
  }

  @Override
  public double distanceM(GoalInformation goal, StateInformation state) {
    Point ahead = towards(({{Name}}) goal, state).point();
    return Math.hypot(ahead.x(), ahead.y());
  }

  @Override
  public Plan plan(Pursuit pursuit) {
    {{Name}} goal = ({{Name}}) pursuit.goal();
    long now = pursuit.state().timestamp().orElseThrow();
    if (arrivedMicros.isEmpty()) {
      if (distanceM(goal, pursuit.state()) > goal.horizontalThreshold()) {
        return Plan.underWay(List.of(towards(goal, pursuit.state())));
      }
      arrivedMicros = OptionalLong.of(now);
    }
    double stayedS = Clock.seconds(now - arrivedMicros.getAsLong());
    return stayedS < goal.stay()
        ? Plan.underWay(List.of()) // no target: the vehicle stops
        : new Plan(List.of(), Plan.Progress.COMPLETED, "stayed " + goal.stay() + " s");
  }

  private static NavigationPoint towards({{Name}} goal, StateInformation state) {
    StateInformation vehicle = state.in(goal.referenceFrame());
    double x = goal.x().orElse(vehicle.x().orElseThrow());
    double y = goal.y().orElse(vehicle.y().orElseThrow());
    double z = goal.z().orElse(vehicle.z().orElse(0.0));
    return NavigationPoint.at(Point.of(x, y, z))
        .referenceFrame(goal.referenceFrame())
        .in(ReferenceFrame.BODY, vehicle);
  }
}
