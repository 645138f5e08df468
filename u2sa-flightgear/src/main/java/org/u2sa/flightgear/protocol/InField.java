package org.u2sa.flightgear.protocol;

import java.util.function.ToDoubleFunction;
import org.u2sa.sim.aircraft.ControlInputs;

/**
 * Fields sent to FlightGear, in line order. Signs are those of FlightGear and {@link
 * ControlInputs}.
 */
public enum InField {
  /** −1…1, positive rolls right. */
  AILERON("/controls/flight/aileron", ControlInputs::aileron),
  /** −1…1, negative is nose up. */
  ELEVATOR("/controls/flight/elevator", ControlInputs::elevator),
  /** −1…1, positive yaws right. */
  RUDDER("/controls/flight/rudder", ControlInputs::rudder),
  /** 0…1. */
  FLAPS("/controls/flight/flaps", ControlInputs::flaps),
  /** 0…1. */
  THROTTLE("/controls/engines/current-engine/throttle", ControlInputs::throttle),
  /** 0…1. */
  MIXTURE("/controls/engines/current-engine/mixture", ControlInputs::mixture),
  /** 0…1. */
  BRAKE_LEFT("/controls/gear/brake-left", ControlInputs::brakeLeft),
  /** 0…1. */
  BRAKE_RIGHT("/controls/gear/brake-right", ControlInputs::brakeRight),
  /** Line counter, which FlightGear echoes as {@link OutField#COUNT}. */
  COUNT("/u2sa/link/count", controls -> 0.0);

  private final String node;
  private final ToDoubleFunction<ControlInputs> value;

  InField(String node, ToDoubleFunction<ControlInputs> value) {
    this.node = node;
    this.value = value;
  }

  /** Path in FlightGear's property tree. */
  public String node() {
    return node;
  }

  double of(ControlInputs controls) {
    return value.applyAsDouble(controls);
  }
}
