package org.u2sa.sim.vehicle;

import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/**
 * A simulated vehicle in a world. Integrates internally at a fixed rate, independent of the
 * requested steps, and is bit-identical on every machine for the same start, world and commands.
 * Not thread-safe; {@link VehicleRun} is.
 */
public interface SimulatedVehicle {
  /** Actuator names used in commands. */
  List<String> actuators();

  /**
   * Sets an actuator command, held until the next one.
   *
   * @param value −1…1, or 0…1 for one-directional actuators; NaN for no signal
   * @throws IllegalArgumentException if the actuator is unknown or the value out of range
   */
  void command(String actuator, double value);

  /**
   * Advances time. The remainder of an internal step carries over to the next call, so many small
   * steps equal one large step.
   *
   * @param dtS time step [s], above 0, at most 60
   * @throws IllegalArgumentException if dt is outside its range
   */
  void step(double dtS);

  /** Current true state. */
  VehicleTruth truth();

  /** Collision outline. */
  Footprint footprint();

  /** The world around the vehicle. */
  World world();

  /** Whether it touches ground on which it is not meant to stand. */
  default boolean isAground() {
    return false;
  }

  /** Current thrust of an actuator, forward positive [N]; empty if the model computes none. */
  default OptionalDouble thrustN(String actuator) {
    return OptionalDouble.empty();
  }

  /**
   * Energy used since the start [J], less the energy fed back by motors; docs/vehicle-files.md
   * states what each kind of vehicle includes. Empty if the model does not compute it.
   */
  default OptionalDouble energyJ() {
    return OptionalDouble.empty();
  }

  /**
   * Velocity of the air around the vehicle: east, north, up [m/s]; the world's steady wind if it
   * has no gusts.
   */
  default Point air() {
    Wind wind = world().wind();
    return Point.of(
        -wind.speedMps() * StrictMath.sin(wind.fromRad()),
        -wind.speedMps() * StrictMath.cos(wind.fromRad()),
        0.0);
  }
}
