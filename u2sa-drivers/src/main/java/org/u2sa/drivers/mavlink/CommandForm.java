package org.u2sa.drivers.mavlink;

import io.dronefleet.mavlink.common.Attitude;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;

/** A MAVLink command encoding and the actuators it provides. */
interface CommandForm {
  /**
   * An actuator.
   *
   * @param minimum minimum percentage [%]
   * @param effect effect on the vehicle
   */
  record Axis(String name, double minimum, String effect) {}

  /** Target of a message. */
  record Target(int systemId, int componentId) {}

  /** The actuators; empty if the autopilot is only a sensor. */
  List<Axis> axes();

  /** Updates the vehicle's attitude, for commands relative to it. */
  default void hear(Attitude attitude, long nowMicros) {}

  /** Whether the vehicle's state suffices to build a message. */
  default boolean isReady(long nowMicros) {
    return true;
  }

  /**
   * Builds the command message; call only if ready.
   *
   * @param percentages percentage of each actuator by name; empty means neutral
   */
  Object message(Target target, Function<String, OptionalDouble> percentages, long nowMicros);

  /** Messages that release control; none if silence suffices. */
  default List<Object> release(Target target) {
    return List.of();
  }

  /** Normalised command of an actuator, −1…1; 0 without a command. */
  static double share(Function<String, OptionalDouble> percentages, String actuator) {
    return percentages.apply(actuator).orElse(0.0) / 100.0 + 0.0; // no negative zero
  }
}
