package org.u2sa.control.fixedwing;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/** Actuators of an aeroplane, by the names used in commands. */
public enum AircraftActuator {
  AILERON("AILERON", Surfaces::aileron),
  ELEVATOR("ELEVATOR", Surfaces::elevator),
  RUDDER("RUDDER", Surfaces::rudder),
  THROTTLE("THROTTLE", Surfaces::throttle),
  MIXTURE("MIXTURE", Surfaces::mixture),
  FLAPS("FLAPS", Surfaces::flaps),
  LEFT_BRAKE("LEFT BRAKE", Surfaces::brakes),
  RIGHT_BRAKE("RIGHT BRAKE", Surfaces::brakes);

  /**
   * Elevator trim at which the Cessna holds about 75 kt, at cruise power and at idle [%], negative:
   * nose up. With a centred elevator it pitches down: a few seconds without commands would cost 100
   * m of altitude.
   */
  public static final double TRIMMED_ELEVATOR_PERCENT = -10.0;

  private final String actuatorName;
  private final ToDoubleFunction<Surfaces> share;

  AircraftActuator(String actuatorName, ToDoubleFunction<Surfaces> share) {
    this.actuatorName = actuatorName;
    this.share = share;
  }

  /** As in {@link org.u2sa.messages.command.ActuatorCommand#actuatorName()}. */
  String actuatorName() {
    return actuatorName;
  }

  /** Command of this actuator among the given surfaces, −1…1. */
  double of(Surfaces surfaces) {
    return share.applyAsDouble(surfaces);
  }

  /**
   * Whether it sets power or configuration rather than attitude, and so holds its value through a
   * short loss of control commands: idling the engine for a few seconds costs more than it saves.
   */
  boolean holdsThroughSilence() {
    return this == THROTTLE || this == MIXTURE || this == FLAPS;
  }

  /** Whether elevons replace it on a flying wing. */
  boolean isElevons() {
    return this == AILERON || this == ELEVATOR;
  }

  /** Neutral command [%]: surfaces centred, engine idling on a rich mixture, brakes off. */
  static Map<String, Double> neutral() {
    Map<String, Double> neutral = new LinkedHashMap<>();
    for (AircraftActuator actuator : values()) {
      neutral.put(actuator.actuatorName(), 0.0);
    }
    neutral.put(ELEVATOR.actuatorName(), TRIMMED_ELEVATOR_PERCENT);
    neutral.put(MIXTURE.actuatorName(), 100.0);
    return neutral;
  }
}
