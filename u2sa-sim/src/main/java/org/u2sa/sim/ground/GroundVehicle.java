package org.u2sa.sim.ground;

import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.world.World;

/**
 * One simulated ground vehicle, on a level lawn until it enters another world. Its place is that of
 * its reference point, the middle of the driven axle; it steps at 500 Hz inside.
 */
public interface GroundVehicle extends SimulatedVehicle {
  /** Rate of the physics inside [1/s]. */
  int TICKS_PER_SECOND = 500;

  /** Commands both inputs at once, and steps. */
  void step(DriveCommand command, double dtS);

  /** The vehicle as it is now, with all that turns and flows in it. */
  GroundState state();

  /**
   * Something pushes the vehicle at its centre of gravity, until told otherwise.
   *
   * @param eastN force towards east [N]
   * @param northN force towards north [N]
   * @param turnNm moment, clockwise positive [N m]
   */
  void push(double eastN, double northN, double turnNm);

  /**
   * Exchanges the battery for one with another charge.
   *
   * @param charge 0…1
   */
  void charge(double charge);

  /** Puts other ground and obstacles around the vehicle, where it is. */
  void enter(World world);
}
