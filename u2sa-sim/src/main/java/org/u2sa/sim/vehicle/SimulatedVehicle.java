package org.u2sa.sim.vehicle;

import java.util.List;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/**
 * One simulated vehicle in a world. It steps at a rate of its own inside, whatever steps it is
 * asked for, and gives the same doubles for the same start, world and commands on every machine.
 * Not safe for several threads: {@link VehicleRun} is.
 */
public interface SimulatedVehicle {
  /** The names of its actuators, as commands address them. */
  List<String> actuators();

  /**
   * Commands an actuator until the next command.
   *
   * @param value −1…1, or 0…1 for one that has no other direction; NaN where no signal comes
   * @throws IllegalArgumentException if there is no such actuator, or it cannot do that
   */
  void command(String actuator, double value);

  /**
   * Moves on in time. What does not fill a step of its own is kept for the next call, so that many
   * small steps equal one large one.
   *
   * @param dtS above 0, at most 60 s
   * @throws IllegalArgumentException if dt is outside its range
   */
  void step(double dtS);

  /** The vehicle as it is now. */
  VehicleTruth truth();

  /** The space that it takes up. */
  Footprint footprint();

  /** What surrounds it. */
  World world();
}
