package org.u2sa.planning.guidance;

import java.util.Optional;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;

/** The wind that a state implies: velocity over ground minus velocity through the air. */
public final class AirMass {
  private AirMass() {}

  /** Wind, the direction to which it blows: north, east [m/s]; empty without an airspeed. */
  public static Optional<Point> wind(StateInformation state, Vehicle vehicle) {
    if (state.fluidxDot().isEmpty()) {
      return Optional.empty();
    }
    Point through =
        new Attitude(state.phi().orElse(0.0), state.theta().orElse(0.0), state.psi().orElseThrow())
            .nedOf(
                Point.of(
                    state.fluidxDot().getAsDouble(),
                    state.fluidyDot().orElse(0.0),
                    state.fluidzDot().orElse(0.0)));
    return Optional.of(
        Point.of(vehicle.northMps() - through.x(), vehicle.eastMps() - through.y(), 0.0));
  }
}
