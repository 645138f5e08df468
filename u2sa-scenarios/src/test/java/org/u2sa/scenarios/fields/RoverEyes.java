package org.u2sa.scenarios.fields;

import org.u2sa.sim.vehicle.VehicleTruth;

/** What tells the rover's planner of its surroundings. */
interface RoverEyes {
  /** What they see. */
  enum Kind {
    /** The truth. */
    KNOWN,
    /** A laser's echoes and a detector's objects, by the World Modeler. */
    DETECTOR,
    /** A laser's echoes, by the World Modeler. */
    LASER
  }

  /** Reach [m]. */
  double RANGE_M = 8.0;

  /** Looks around and publishes what there is. */
  void look(VehicleTruth truth);
}
