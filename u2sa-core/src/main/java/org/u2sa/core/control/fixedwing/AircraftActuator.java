package org.u2sa.core.control.fixedwing;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/** An aeroplane's actuators by the names that commands address. */
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
   * Elevator at which the Cessna holds about 75 kt by itself, at cruise power as at idle [%],
   * negative: nose up. Centred, it noses over: a silence of a few seconds would cost 100 m.
   */
  public static final double TRIMMED_ELEVATOR_PERCENT = -10.0;

  private final String actuatorName;
  private final ToDoubleFunction<Surfaces> share;

  AircraftActuator(String actuatorName, ToDoubleFunction<Surfaces> share) {
    this.actuatorName = actuatorName;
    this.share = share;
  }

  /** As in {@link org.u2sa.messages.ActuatorCommand#actuatorName()}. */
  String actuatorName() {
    return actuatorName;
  }

  /** What the surfaces ask of this actuator, −1…1. */
  double of(Surfaces surfaces) {
    return share.applyAsDouble(surfaces);
  }

  /**
   * Whether it sets power or shape rather than attitude: what a short silence of control should not
   * change, as an engine that idles for a few seconds costs more than it saves.
   */
  boolean holdsThroughSilence() {
    return this == THROTTLE || this == MIXTURE || this == FLAPS;
  }

  /** Surfaces left alone, engine idling on a rich mixture, brakes off [%]. */
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
