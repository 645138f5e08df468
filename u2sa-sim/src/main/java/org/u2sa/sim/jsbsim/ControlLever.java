package org.u2sa.sim.jsbsim;

import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * An aircraft's commands, with the properties that they set. Signs are those of the simulated
 * Cessna: ailerons roll right, the elevator pitches down, the rudder yaws right.
 */
enum ControlLever {
  AILERON("AILERON", -1.0, 1.0, "fcs/aileron-cmd-norm", "fcs/left-aileron-pos-rad"),
  ELEVATOR("ELEVATOR", -1.0, 1.0, "fcs/elevator-cmd-norm", "fcs/elevator-pos-rad"),
  RUDDER("RUDDER", -1.0, -1.0, "fcs/rudder-cmd-norm", "fcs/rudder-pos-rad"),
  THROTTLE("THROTTLE", 0.0, 1.0, "fcs/throttle-cmd-norm", ""),
  FLAPS("FLAPS", 0.0, 1.0, "fcs/flap-cmd-norm", ""),
  LEFT_BRAKE("LEFT BRAKE", 0.0, 1.0, "fcs/left-brake-cmd-norm", ""),
  RIGHT_BRAKE("RIGHT BRAKE", 0.0, 1.0, "fcs/right-brake-cmd-norm", "");

  private static final List<String> TRIMS = List.of("pitch", "roll", "yaw");

  private final String actuator;
  private final double lowest;
  private final double sign;
  private final String command;
  private final String surface;

  ControlLever(String actuator, double lowest, double sign, String command, String surface) {
    this.actuator = actuator;
    this.lowest = lowest;
    this.sign = sign;
    this.command = command;
    this.surface = surface;
  }

  static ControlLever of(String actuator) {
    return Stream.of(values())
        .filter(each -> each.actuator.equals(actuator))
        .findFirst()
        .orElseThrow();
  }

  static List<String> names() {
    return Stream.of(values()).map(ControlLever::actuator).collect(Collectors.toList());
  }

  String actuator() {
    return actuator;
  }

  double lowest() {
    return lowest;
  }

  void define(PropertyTree properties) {
    properties.define(command, 0.0);
    TRIMS.forEach(axis -> properties.define("fcs/" + axis + "-trim-cmd-norm", 0.0));
    properties.define("fcs/mixture-cmd-norm", 1.0);
    properties.define("fcs/advance-cmd-norm", 1.0);
    properties.define("gear/gear-cmd-norm", 1.0);
    properties.define("gear/gear-pos-norm", 1.0);
  }

  /** Whether an aircraft has this control. */
  boolean isNeeded(PropertyTree properties, boolean hasEngines, boolean hasBrakes) {
    return switch (this) {
      case THROTTLE -> hasEngines;
      case LEFT_BRAKE, RIGHT_BRAKE -> hasBrakes;
      default -> properties.isRead(command);
    };
  }

  /** Sets the command; for each engine the throttle, mixture and propeller lever. */
  void apply(PropertyTree properties, double value, int engines) {
    properties.set(command, sign * value);
    for (int i = 0; this == THROTTLE && i < engines; i++) {
      String index = "[" + i + "]";
      properties.set("fcs/throttle-cmd-norm" + index, value);
      properties.set("fcs/throttle-pos-norm" + index, value);
      properties.set("fcs/mixture-pos-norm" + index, properties.get("fcs/mixture-cmd-norm"));
      properties.set("fcs/advance-pos-norm" + index, properties.get("fcs/advance-cmd-norm"));
    }
  }

  /** Current angle of its surface [rad]; empty if it moves no surface. */
  OptionalDouble angleRad(PropertyTree properties) {
    return surface.isEmpty() ? OptionalDouble.empty() : OptionalDouble.of(properties.get(surface));
  }
}
