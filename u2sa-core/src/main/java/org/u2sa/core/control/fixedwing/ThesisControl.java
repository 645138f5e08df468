package org.u2sa.core.control.fixedwing;

import java.util.Map;
import java.util.Optional;
import org.u2sa.core.control.ControlSystem;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
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
  static final VariableDeclaration<Double> DIRECTION_GAIN =
      VariableDeclaration.number("DIRECTION GAIN", "")
          .range(Range.of(0.0, 5.0))
          .ifAbsent(1.0)
          .describedAs("Aileron at a direction of 180 degrees, of full; thesis: 1.");

  static final VariableDeclaration<Double> DIRECTION_LIMIT =
      VariableDeclaration.number("DIRECTION LIMIT", "deg")
          .range(Range.of(1.0, 180.0))
          .ifAbsent(30.0)
          .describedAs("Direction beyond which the aileron moves no further; thesis: 180.");

  static final VariableDeclaration<Double> BANK_GAIN =
      VariableDeclaration.number("BANK GAIN", "1/rad")
          .range(Range.of(0.0, 5.0))
          .ifAbsent(0.4)
          .describedAs("Aileron against the bank; thesis: 0.");

  static final VariableDeclaration<Double> ALTITUDE_GAIN =
      VariableDeclaration.number("ALTITUDE GAIN", "")
          .range(Range.of(0.0, 1.0))
          .ifAbsent(0.3)
          .describedAs("Elevator at an altitude differential of 1000 ft or more, of full.");

  static final VariableDeclaration<Double> PITCH_GAIN =
      VariableDeclaration.number("PITCH GAIN", "1/rad")
          .range(Range.of(0.0, 5.0))
          .ifAbsent(1.5)
          .describedAs("Elevator against the pitch; thesis: 0.");

  static final VariableDeclaration<Double> LEVEL_PITCH =
      VariableDeclaration.number("LEVEL PITCH", "deg")
          .range(Range.of(-5.0, 15.0))
          .ifAbsent(6.0)
          .describedAs("Pitch at which the elevator is centred.");

  static final VariableDeclaration<Double> CRUISE_THROTTLE =
      VariableDeclaration.number("CRUISE THROTTLE", "")
          .range(Range.of(0.1, 1.0))
          .ifAbsent(0.6)
          .describedAs("Throttle of level flight.");

  private static final double FULL_PERCENT = 100.0;

  private final FlightStateReader reader = new FlightStateReader();
  private final ThesisLaw law;

  /** Called by the launcher. */
  public ThesisControl(ServiceContext context) {
    super(context, "Control");
    law =
        new ThesisLaw(
            new ThesisLaw.Parameters(
                getVariable(DIRECTION_GAIN),
                Math.toRadians(getVariable(DIRECTION_LIMIT)),
                getVariable(BANK_GAIN),
                getVariable(ALTITUDE_GAIN),
                getVariable(PITCH_GAIN),
                Math.toRadians(getVariable(LEVEL_PITCH)),
                getVariable(CRUISE_THROTTLE)));
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
