package org.u2sa.sim.vehicle;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.u2sa.messages.ObjectDescription;

/** Counts how often a vehicle runs into obstacles: a touch that lasts is one. For one thread. */
public final class ContactWatch {
  /**
   * The begin of a touch.
   *
   * @param timeS simulated time [s]
   * @param object what was touched
   */
  public record Contact(double timeS, ObjectDescription object) {}

  private final Consumer<Contact> listener;
  private Set<String> touching = new HashSet<>();

  /**
   * @param listener is told of every touch that begins
   */
  public ContactWatch(Consumer<Contact> listener) {
    this.listener = listener;
  }

  /** Looks at a vehicle as it is now; call it after every step. */
  public void look(SimulatedVehicle vehicle, VehicleTruth truth) {
    if (vehicle.world().obstacles().isEmpty()) {
      return;
    }
    List<ObjectDescription> touched =
        vehicle.world().contacts(vehicle.footprint(), truth.position(), truth.headingRad());
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
