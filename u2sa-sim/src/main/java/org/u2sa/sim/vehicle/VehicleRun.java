package org.u2sa.sim.vehicle;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * A vehicle in a run. Sensors, actuators and observers share it: whoever comes first at a time
 * moves the vehicle on to it. Its time begins with the first call. Safe for all threads; the same
 * calls in the same order give the same run.
 */
public final class VehicleRun {
  private static final double US_PER_S = 1e6;

  private final SimulatedVehicle vehicle;
  private final List<ContactWatch.Contact> contacts = new CopyOnWriteArrayList<>();
  private final ContactWatch watch = new ContactWatch(contacts::add);
  private VehicleTruth truth;
  private long beginMicros = -1;
  private long steppedMicros;

  /**
   * @param vehicle that nobody else steps
   */
  public VehicleRun(SimulatedVehicle vehicle) {
    this.vehicle = vehicle;
    truth = vehicle.truth();
  }

  /**
   * The vehicle at a time; as it is now if that has passed.
   *
   * @param nowMicros of the run's clock [µs]
   */
  public synchronized VehicleTruth at(long nowMicros) {
    if (beginMicros < 0) {
      beginMicros = nowMicros;
    }
    long elapsed = nowMicros - beginMicros;
    if (elapsed > steppedMicros) {
      vehicle.step((elapsed - steppedMicros) / US_PER_S);
      steppedMicros = elapsed;
      truth = vehicle.truth();
      watch.look(vehicle, truth);
    }
    return truth;
  }

  /**
   * Commands an actuator from a time on; see {@link SimulatedVehicle#command}.
   *
   * @param nowMicros of the run's clock [µs]
   */
  public synchronized void command(long nowMicros, String actuator, double value) {
    at(nowMicros);
    vehicle.command(actuator, value);
  }

  /** The vehicle, for what does not change: its actuators, footprint and world. */
  public SimulatedVehicle vehicle() {
    return vehicle;
  }

  /** Every touch of an obstacle so far. */
  public List<ContactWatch.Contact> contacts() {
    return List.copyOf(contacts);
  }
}
