package org.u2sa.sim.vehicle;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * A vehicle shared by sensors, actuators and observers of a run: the first access at a time
 * advances the vehicle to it. Time starts at the first call. A jump of the clock, as when the
 * machine slept, advances it by the longest step only. Thread-safe; deterministic for the same
 * sequence of calls.
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
   * @param vehicle vehicle, stepped only by this object
   */
  public VehicleRun(SimulatedVehicle vehicle) {
    this.vehicle = vehicle;
    truth = vehicle.truth();
  }

  /**
   * State at a time; the current state if that time has passed.
   *
   * @param nowMicros of the run's clock [µs]
   */
  public synchronized VehicleTruth at(long nowMicros) {
    if (beginMicros < 0) {
      beginMicros = nowMicros;
    }
    long elapsed = nowMicros - beginMicros;
    if (elapsed > steppedMicros) {
      vehicle.step(Math.min(FixedStep.LONGEST_STEP_S, (elapsed - steppedMicros) / US_PER_S));
      steppedMicros = elapsed;
      truth = vehicle.truth();
      watch.look(vehicle, truth);
    }
    return truth;
  }

  /**
   * Sets an actuator command from a time onward; see {@link SimulatedVehicle#command}.
   *
   * @param nowMicros of the run's clock [µs]
   */
  public synchronized void command(long nowMicros, String actuator, double value) {
    at(nowMicros);
    vehicle.command(actuator, value);
  }

  /** The vehicle, for immutable properties: actuators, footprint and world. */
  public SimulatedVehicle vehicle() {
    return vehicle;
  }

  /** All obstacle contacts so far. */
  public List<ContactWatch.Contact> contacts() {
    return List.copyOf(contacts);
  }
}
