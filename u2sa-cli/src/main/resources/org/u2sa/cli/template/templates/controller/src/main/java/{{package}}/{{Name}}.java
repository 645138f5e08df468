package {{package}};

import java.util.Map;
import java.util.Optional;
import org.u2sa.control.ControlSystem;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.ServiceContext;

/**
 * Steers a vehicle with two driven wheels to its navigation point. In: navigation, state. Out:
 * actuation.
 */
public final class {{Name}} extends ControlSystem {
  private static final String LEFT = "LEFT MOTOR";
  private static final String RIGHT = "RIGHT MOTOR";

  private record Variables(
      @Variable(unit = "%", min = 0, max = 100, ifAbsent = 50)
          @Description("Power of both motors straight ahead.")
          double power,
      @Variable(unit = "%/rad", min = 0, max = 500, ifAbsent = 40)
          @Description("Differential power per radian of bearing.")
          double bearingGain) {}

  private final Settings<Variables> tuning = settings(Variables.class);

  public {{Name}}(ServiceContext context) {
    super(context, "{{Name}}");
  }

  @Override
  protected void control(StateInformation state, Optional<NavigationPoint> point) {
    if (point.isEmpty()) { // no goal, or the planner is silent
      neutral().forEach(this::command);
      return;
    }
    Point ahead = point.get().point(); // in the vehicle's frame: x is forward, y is left
    double bearing = Math.atan2(ahead.y(), ahead.x());
    double forward = tuning.get().power() * Math.max(0.0, Math.cos(bearing));
    double turn = tuning.get().bearingGain() * bearing;
    command(LEFT, forward - turn);
    command(RIGHT, forward + turn);
  }

  @Override
  protected Map<String, Double> neutral() {
    return Map.of(LEFT, 0.0, RIGHT, 0.0);
  }
}
