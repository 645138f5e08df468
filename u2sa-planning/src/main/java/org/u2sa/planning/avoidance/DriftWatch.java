package org.u2sa.planning.avoidance;

import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.service.motion.Drift;
import org.u2sa.service.motion.DriftFilter;

/**
 * Estimates the drift of a vehicle that DRIFTS from its states. Confined to the planner's thread.
 */
final class DriftWatch {
  private static final double LONGEST_S = 1.0; // maximum time between states used for the drift

  private final Supplier<AvoidanceVariables> settings;
  private final DriftFilter filter = new DriftFilter();
  private long lastMicros;

  DriftWatch(Supplier<AvoidanceVariables> settings) {
    this.settings = settings;
  }

  void see(Vehicle vehicle) {
    double stepS = Clock.seconds(vehicle.timestampMicros() - lastMicros);
    lastMicros = vehicle.timestampMicros();
    if (settings.get().drifts() && stepS < LONGEST_S) {
      double heading = vehicle.headingRad();
      double right = vehicle.eastMps() * Math.cos(heading) - vehicle.northMps() * Math.sin(heading);
      filter.step(heading, right, vehicle.turnRadps(), stepS);
    }
  }

  Drift drift() {
    return settings.get().drifts() ? filter.drift() : Drift.NONE;
  }
}
