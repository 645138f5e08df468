package org.u2sa.control.subsystem;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.u2sa.control.ControlSystem;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.ServiceContext;

/**
 * Commands switched payloads, such as launchers and drop mechanisms, at 100 % while a planner
 * publishes navigation points for the subsystem of their name, otherwise at 0 % (thesis 4.3.1.5).
 * In: navigation, state. Out: actuation.
 */
public final class ReleaseControl extends ControlSystem {
  private static final double RELEASED_PERCENT = 100.0;

  private record Variables(
      @Variable
          @Description(
              "Actuators, separated by commas. Each is also the name of its subsystem in navigation points.")
          String actuators) {}

  private final List<String> actuators;

  public ReleaseControl(ServiceContext context) {
    super(context, "ReleaseControl");
    actuators =
        Arrays.stream(settings(Variables.class).get().actuators().split(","))
            .map(String::trim)
            .filter(name -> !name.isEmpty())
            .collect(Collectors.toList());
  }

  @Override
  protected void control(StateInformation state, Optional<NavigationPoint> point) {
    for (String actuator : actuators) {
      command(actuator, navigationPoint(actuator).isPresent() ? RELEASED_PERCENT : 0.0);
    }
  }

  @Override
  protected boolean obeysWithoutState() {
    return true;
  }

  @Override
  protected Map<String, Double> neutral() {
    Map<String, Double> safe = new LinkedHashMap<>();
    actuators.forEach(actuator -> safe.put(actuator, 0.0));
    return safe;
  }
}
