package org.u2sa.scenarios.fields;

import org.u2sa.sim.vehicle.VehicleTruth;

/** What tells the rover's planner of its surroundings. */
interface RoverEyes {
  /** Reach [m]. */
  double RANGE_M = 8.0;

  /** Looks around and publishes what there is. */
  void look(VehicleTruth truth);
}
