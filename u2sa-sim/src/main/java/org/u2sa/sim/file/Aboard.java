package org.u2sa.sim.file;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.device.SimulatedTraffic;
import org.u2sa.sim.ground.GroundState;
import org.u2sa.sim.ground.GroundVehicle;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.RunningVehicle;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.World;

/**
 * Environment of a device of a simulated vehicle.
 *
 * @param world world around the vehicle
 * @param truth current state of the vehicle
 * @param air current velocity of the air around the vehicle: east, north, up [m/s]
 * @param wheels current state of a ground vehicle's wheels
 * @param traffic current states of other vehicles
 * @param thrustN current thrust of an actuator [N]; empty if the model computes none
 * @param streams the device's own random numbers
 */
record Aboard(
    World world,
    Supplier<VehicleTruth> truth,
    Supplier<Point> air,
    Supplier<GroundState> wheels,
    Supplier<List<SimulatedTraffic.Other>> traffic,
    Function<String, OptionalDouble> thrustN,
    NoiseStreams streams) {

  /**
   * Environment of the devices of a running vehicle.
   *
   * @param nowMicros time of the run [µs]
   */
  static Aboard of(
      RunningVehicle run,
      LongSupplier nowMicros,
      Supplier<List<SimulatedTraffic.Other>> traffic,
      NoiseStreams streams) {
    return new Aboard(
        run.vehicle().world(),
        () -> run.at(nowMicros.getAsLong()),
        () -> run.read(nowMicros.getAsLong(), SimulatedVehicle::air),
        () -> run.read(nowMicros.getAsLong(), vehicle -> ((GroundVehicle) vehicle).state()),
        traffic,
        actuator -> run.read(nowMicros.getAsLong(), vehicle -> vehicle.thrustN(actuator)),
        streams);
  }

  /** Current state of a sensor on the vehicle. */
  Supplier<VehicleTruth> at(Mount mount) {
    return mount.following(truth);
  }

  /** Altitude of a point on the vehicle above mean sea level [m]. */
  double altitudeM(Mount mount) {
    Point place = mount.of(truth.get()).position();
    return world.plane().at(place.x(), place.y(), place.z()).altitudeM();
  }
}
