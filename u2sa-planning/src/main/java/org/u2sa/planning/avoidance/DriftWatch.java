package org.u2sa.planning.avoidance;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.local.Drift;

/**
 * Learns the {@link Drift} from the vehicle's sideways velocity, averaged over a few waves. Confined
 * to the planner's thread.
 */
final class DriftWatch {
  private static final double AVERAGED_S = 3.0;
  private static final double LONGEST_S = 1.0; // between states

  double northMps;
  double eastMps;
  private long lastMicros = Long.MIN_VALUE / 2;

  /** The drift after a state of the vehicle. */
  Drift see(Vehicle vehicle) {
    double passed = Clock.seconds(vehicle.timestampMicros() - lastMicros);
    lastMicros = vehicle.timestampMicros();
    double heading = vehicle.headingRad();
    double right =
        vehicle.eastMps() * Math.cos(heading) - vehicle.northMps() * Math.sin(heading);
    double share = passed > 0.0 && passed < LONGEST_S ? passed / AVERAGED_S : 0.0;
    northMps += share * (-right * Math.sin(heading) - northMps);
    eastMps += share * (right * Math.cos(heading) - eastMps);
    return new Drift(northMps, eastMps);
  }
}
