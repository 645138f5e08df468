package org.u2sa.sim.file;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.world.World;

/**
 * One kind of dynamics, with the parameters of a vehicle file. A new kind is an implementation and
 * one entry in {@link VehicleModels}.
 */
public interface VehicleModel {
  /** Domain of vehicles of this kind. */
  enum Medium {
    /** On the ground. */
    GROUND,
    /** On or under water. */
    WATER,
    /** In the air. */
    AIR
  }

  /**
   * Wheels that encoders can count.
   *
   * @param trackM distance between the left and right wheels of a vehicle that would turn at the
   *     same rate without sideslip of its wheels [m]
   * @param radiusM [m]
   */
  record Wheels(double trackM, double radiusM) {}

  /** Domain in which it moves. */
  Medium medium();

  /** Whether it moves under water. */
  default boolean isSubmerged() {
    return false;
  }

  /** Whether only the service that commands the vehicle advances it; sensors must not. */
  default boolean isSteppedByOwner() {
    return false;
  }

  /** Names of its actuators, as in commands. */
  List<String> actuators();

  /** Lowest command of an actuator: −1, or 0 if it turns only one way. */
  default double lowest(String actuator) {
    return -1.0;
  }

  /** Time at which an actuator is disconnected [s]; infinite for never. */
  default double failsAtS(String actuator) {
    return Double.POSITIVE_INFINITY;
  }

  /** Angle of a servo at full command [rad]; empty for other actuators. */
  default OptionalDouble travelRad(String actuator) {
    return OptionalDouble.empty();
  }

  /** Mass [kg], if it differs from the body's. */
  default OptionalDouble massKg() {
    return OptionalDouble.empty();
  }

  /** Wheels with encoders; empty if none. */
  default Optional<Wheels> wheels() {
    return Optional.empty();
  }

  /**
   * Creates a vehicle at rest.
   *
   * @param start east, north, up [m]
   * @param headingRad clockwise from north [rad]
   * @param seed seed of the deviations from nominal parameters
   */
  SimulatedVehicle make(World world, Point start, double headingRad, long seed);
}
