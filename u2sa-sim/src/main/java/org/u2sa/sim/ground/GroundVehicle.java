package org.u2sa.sim.ground;

import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.world.World;

/**
 * A simulated ground vehicle, on a level lawn unless placed in a world. Its position is that of its
 * reference point, the centre of the driven axle. Integrates internally at 500 Hz.
 */
public interface GroundVehicle extends SimulatedVehicle {
  /** Internal integration rate [1/s]. */
  int TICKS_PER_SECOND = 500;

  /** Sets both inputs and steps. */
  void step(DriveCommand command, double dtS);

  /** Current state, including wheels, motors and battery. */
  GroundState state();

  /**
   * Applies an external force at the centre of gravity until changed.
   *
   * @param eastN east force [N]
   * @param northN north force [N]
   * @param turnNm moment, clockwise positive [N m]
   */
  void push(double eastN, double northN, double turnNm);

  /**
   * Sets the battery's state of charge.
   *
   * @param charge 0…1
   */
  void charge(double charge);

  /** Places the vehicle, at its current position, in a world with its ground and obstacles. */
  void enter(World world);
}
