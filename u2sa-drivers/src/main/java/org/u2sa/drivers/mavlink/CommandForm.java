package org.u2sa.drivers.mavlink;

import io.dronefleet.mavlink.common.Attitude;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;

/** A form in which an autopilot takes commands, and the actuators that it makes of it. */
interface CommandForm {
  /**
   * One actuator.
   *
   * @param minimum smallest percentage it takes [%]
   * @param effect what moving it does to the vehicle
   */
  record Axis(String name, double minimum, String effect) {}

  /** To whom a message goes. */
  record Target(int systemId, int componentId) {}

  /** The actuators; none if the autopilot is a sensor only. */
  List<Axis> axes();

  /** Takes note of how the vehicle lies, for commands that are relative to it. */
  default void hear(Attitude attitude, long nowMicros) {}

  /** Whether enough is known of the vehicle to make a message. */
  default boolean isReady(long nowMicros) {
    return true;
  }

  /**
   * The message that commands them; only if it is ready.
   *
   * @param percentages of each actuator by name; empty is its neutral
   */
  Object message(Target target, Function<String, OptionalDouble> percentages, long nowMicros);

  /** The messages that give control back; none if silence does. */
  default List<Object> release(Target target) {
    return List.of();
  }

  /** An actuator's share of full, −1…1; 0 where nothing is commanded. */
  static double share(Function<String, OptionalDouble> percentages, String actuator) {
    return percentages.apply(actuator).orElse(0.0) / 100.0 + 0.0; // no negative zero
  }
}
