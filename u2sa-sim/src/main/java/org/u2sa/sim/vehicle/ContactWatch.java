package org.u2sa.sim.vehicle;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.sim.world.World;

/**
 * Counts a vehicle's contacts with obstacles and with ground on which it is not meant to stand; a
 * continuous contact counts once. Not thread-safe.
 */
public final class ContactWatch {
  /**
   * Start of a contact.
   *
   * @param timeS simulated time [s]
   * @param object the object touched
   */
  public record Contact(double timeS, ObjectDescription object) {}

  private static final ObjectDescription GROUND = new ObjectDescription().uid("ground");

  private final Consumer<Contact> listener;
  private Set<String> touching = new HashSet<>();

  /**
   * @param listener called for each new contact
   */
  public ContactWatch(Consumer<Contact> listener) {
    this.listener = listener;
  }

  /** Uids of what a vehicle touches now; "ground" for ground on which it is not meant to stand. */
  public static List<String> touched(SimulatedVehicle vehicle, VehicleTruth truth) {
    return objects(vehicle, truth).stream().map(ObjectDescription::uid).toList();
  }

  private static List<ObjectDescription> objects(SimulatedVehicle vehicle, VehicleTruth truth) {
    World world = vehicle.world().when(truth.timeS());
    List<ObjectDescription> touched =
        world.contacts(vehicle.footprint(), truth.position(), truth.headingRad());
    if (vehicle.isAground()) {
      touched.add(GROUND);
    }
    return touched;
  }

  /** Checks the vehicle's current state; call after every step. */
  public void look(SimulatedVehicle vehicle, VehicleTruth truth) {
    List<ObjectDescription> touched = objects(vehicle, truth);
    if (touched.isEmpty() && touching.isEmpty()) {
      return;
    }
    Set<String> now = new HashSet<>();
    for (ObjectDescription object : touched) {
      now.add(object.uid());
      if (!touching.contains(object.uid())) {
        listener.accept(new Contact(truth.timeS(), object));
      }
    }
    touching = now;
  }
}
