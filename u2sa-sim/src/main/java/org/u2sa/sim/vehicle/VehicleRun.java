package org.u2sa.sim.vehicle;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import org.u2sa.interfaces.RunFailedException;

/**
 * A vehicle shared by sensors, actuators and observers of a run: the first access at a time
 * advances the vehicle to it. Time starts at the first call. After a clock jump, e.g. because the
 * machine slept, it advances by the longest step only. Thread-safe; deterministic for the same
 * sequence of calls.
 */
public final class VehicleRun implements RunningVehicle {
  private static final double US_PER_S = 1e6;

  private final SimulatedVehicle vehicle;
  private final List<ContactWatch.Contact> contacts = new CopyOnWriteArrayList<>();
  private final ContactWatch watch = new ContactWatch(contacts::add);
  private VehicleTruth truth;
  private final Map<String, Long> expiries = new LinkedHashMap<>(); // by actuator [µs]
  private long beginMicros = -1;
  private long steppedMicros;

  /**
   * @param vehicle vehicle, stepped only by this object
   */
  public VehicleRun(SimulatedVehicle vehicle) {
    this.vehicle = vehicle;
    truth = vehicle.truth();
  }

  @Override
  public synchronized VehicleTruth at(long nowMicros) {
    if (beginMicros < 0) {
      beginMicros = nowMicros;
    }
    for (long next = nextExpiry(nowMicros); next < nowMicros; next = nextExpiry(nowMicros)) {
      step(next);
      expire(next);
    }
    step(nowMicros);
    return truth;
  }

  @Override
  public synchronized <T> T read(long nowMicros, Function<SimulatedVehicle, T> property) {
    at(nowMicros);
    return property.apply(vehicle);
  }

  private void step(long nowMicros) {
    long elapsed = nowMicros - beginMicros;
    if (elapsed > steppedMicros) {
      try {
        vehicle.step(Math.min(FixedStep.LONGEST_STEP_S, (elapsed - steppedMicros) / US_PER_S));
        truth = vehicle.truth();
      } catch (IllegalArgumentException e) {
        throw new RunFailedException(
            String.format(
                Locale.ROOT,
                "the simulated vehicle's motion diverged at %.1f s (%s); check its parameters",
                elapsed / US_PER_S,
                e.getMessage()),
            e);
      }
      steppedMicros = elapsed;
      watch.look(vehicle, truth);
    }
  }

  private long nextExpiry(long nowMicros) {
    return expiries.values().stream().reduce(nowMicros, Math::min);
  }

  private void expire(long micros) {
    for (Map.Entry<String, Long> each : List.copyOf(expiries.entrySet())) {
      if (each.getValue() <= micros) {
        expiries.remove(each.getKey());
        vehicle.command(each.getKey(), Double.NaN);
      }
    }
  }

  /**
   * Sets an actuator command from a time onward; see {@link SimulatedVehicle#command}.
   *
   * @param nowMicros of the run's clock [µs]
   */
  public synchronized void command(long nowMicros, String actuator, double value) {
    at(nowMicros);
    vehicle.command(actuator, value);
    expiries.remove(actuator);
  }

  /**
   * Sets an actuator command that expires, like that of a controller with a time-out: afterwards
   * the actuator has no signal.
   *
   * @param nowMicros of the run's clock [µs]
   * @param untilMicros end of the command [µs]
   */
  public synchronized void command(
      long nowMicros, String actuator, double value, long untilMicros) {
    command(nowMicros, actuator, value);
    expiries.put(actuator, untilMicros);
  }

  /**
   * The vehicle for readers that must not advance it because a single service does so; they see its
   * latest state.
   */
  public Readers readers() {
    return new Readers(this);
  }

  private synchronized VehicleTruth latest() {
    return truth;
  }

  private synchronized <T> T latest(Function<SimulatedVehicle, T> property) {
    return property.apply(vehicle);
  }

  /**
   * A vehicle that only its owner advances.
   *
   * @param owned the vehicle as seen by the owner
   */
  public record Readers(VehicleRun owned) implements RunningVehicle {
    @Override
    public VehicleTruth at(long nowMicros) {
      return owned.latest();
    }

    @Override
    public <T> T read(long nowMicros, Function<SimulatedVehicle, T> property) {
      return owned.latest(property);
    }

    @Override
    public SimulatedVehicle vehicle() {
      return owned.vehicle();
    }

    @Override
    public List<ContactWatch.Contact> contacts() {
      return owned.contacts();
    }
  }

  @Override
  public SimulatedVehicle vehicle() {
    return vehicle;
  }

  @Override
  public List<ContactWatch.Contact> contacts() {
    return List.copyOf(contacts);
  }
}
