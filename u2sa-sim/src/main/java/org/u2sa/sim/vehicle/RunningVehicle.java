package org.u2sa.sim.vehicle;

import java.util.List;
import java.util.function.Function;

/** A vehicle shared by sensors, actuators and observers of a run. Thread-safe. */
public interface RunningVehicle {
  /**
   * State at the given time; the current state if that time has passed.
   *
   * @param nowMicros of the run's clock [µs]
   */
  VehicleTruth at(long nowMicros);

  /**
   * A property of the vehicle at the given time, read between steps.
   *
   * @param nowMicros of the run's clock [µs]
   */
  <T> T read(long nowMicros, Function<SimulatedVehicle, T> property);

  /** The vehicle, for immutable properties: actuators, footprint and world. */
  SimulatedVehicle vehicle();

  /** All obstacle contacts so far. */
  List<ContactWatch.Contact> contacts();
}
