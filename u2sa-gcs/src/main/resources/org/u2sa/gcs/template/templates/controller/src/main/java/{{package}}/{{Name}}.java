package {{package}};

import java.util.Map;
import java.util.Optional;
import org.u2sa.core.control.ControlSystem;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.ServiceContext;

/** Turns a vehicle with two driven wheels to where it is to go. In: navigation, state. Out: actuation. */
public final class {{Name}} extends ControlSystem {
  private static final String LEFT = "LEFT MOTOR";
  private static final String RIGHT = "RIGHT MOTOR";

  private static final Variable<Double> POWER =
      Variable.number("POWER", "%")
          .range(Range.of(0.0, 100.0))
          .ifAbsent(50.0)
          .describedAs("Both wheels, straight ahead.");

  private static final Variable<Double> TURN_GAIN =
      Variable.number("TURN GAIN", "%/rad")
          .range(Range.of(0.0, 500.0))
          .ifAbsent(40.0)
          .describedAs("Each wheel, for each radian that the point lies to a side.");

  /** Called by the launcher. */
  public {{Name}}(ServiceContext context) {
    super(context, "{{Name}}");
    getVariable(POWER); // wrong values must fail before the drive
    getVariable(TURN_GAIN);
  }

  @Override
  protected void control(StateInformation state, Optional<NavigationPoint> point) {
    if (point.isEmpty()) { // no goal, or the planner is silent
      neutral().forEach(this::command);
      return;
    }
    Point ahead = point.get().point(); // in the vehicle's frame: x is forward, y is left
    double bearing = Math.atan2(ahead.y(), ahead.x());
    double forward = getVariable(POWER) * Math.max(0.0, Math.cos(bearing));
    double turn = getVariable(TURN_GAIN) * bearing;
    command(LEFT, forward - turn);
    command(RIGHT, forward + turn);
  }

  @Override
  protected Map<String, Double> neutral() {
    return Map.of(LEFT, 0.0, RIGHT, 0.0);
  }
}
