package org.u2sa.core.control.fixedwing;

import java.util.Map;
import java.util.Optional;
import org.u2sa.core.control.ControlSystem;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.ServiceContext;

/**
 * The control of the thesis's Cessna (4.5.2.5), kept to teach from. In: state, navigation. Out:
 * actuation. It keeps an aircraft in the air and brings it past waypoints in calm air; it knows no
 * airspeed, wind, stall or runway: for those see {@link CessnaControl}. Without fresh navigation it
 * commands nothing, and actuators fall back when their commands expire.
 */
public final class ThesisControl extends ControlSystem {
  private static final double FULL_PERCENT = 100.0;

  private final FlightStateReader reader = new FlightStateReader();
  private final ThesisLaw law;

  /** Called by the launcher. */
  public ThesisControl(ServiceContext context) {
    super(context, "Control");
    law = new ThesisLaw(settings(ThesisLaw.Parameters.class).get());
  }

  @Override
  protected void control(StateInformation state, Optional<NavigationPoint> point) {
    Optional<FlightState> seen = reader.read(state);
    Optional<Point> ned = point.flatMap(this::nedOf);
    if (seen.isEmpty() || ned.isEmpty()) {
      return;
    }
    Point ahead = ned.get();
    FlightState now = seen.get();
    GuidanceTarget target =
        new GuidanceTarget(
            ahead.x(), ahead.y(), now.altitudeM() - ahead.z(), point.orElseThrow().speed());
    Surfaces surfaces = law.surfaces(now, target);
    for (AircraftActuator actuator : AircraftActuator.values()) {
      command(actuator.actuatorName(), FULL_PERCENT * actuator.of(surfaces));
    }
  }

  @Override
  protected Map<String, Double> neutral() {
    return AircraftActuator.neutral();
  }
}
