package org.u2sa.sim.file;

import org.u2sa.messages.frame.Point;
import org.u2sa.sim.ground.GroundVehicle;
import org.u2sa.sim.world.World;

/** Dynamics of a vehicle on the ground, which an IOIO board can drive. */
interface GroundModel extends VehicleModel {
  @Override
  default Medium medium() {
    return Medium.GROUND;
  }

  @Override
  GroundVehicle make(World world, Point start, double headingRad, long seed);
}
