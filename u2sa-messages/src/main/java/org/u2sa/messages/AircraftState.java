package org.u2sa.messages;

import java.util.OptionalDouble;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/**
 * State of an aeroplane: adds fields for wings, wheels and engine. Readers that do not know this
 * class receive a {@link StateInformation}.
 */
public class AircraftState extends StateInformation {
  private static final Schema<AircraftState> SCHEMA =
      Schema.of("AircraftState", AircraftState.class, AircraftState::new, StateInformation.TYPE);
  private static final NumberField<AircraftState> HEIGHT_ABOVE_GROUND =
      SCHEMA.optionalNumber("heightAboveGround", "m");
  private static final NumberField<AircraftState> CALIBRATED_AIRSPEED =
      SCHEMA.optionalNumber("calibratedAirspeed", "m/s", 0.0);
  private static final NumberField<AircraftState> ENGINE_RPM =
      SCHEMA.optionalNumber("engineRpm", "rpm", 0.0);
  private static final ValueField<AircraftState, Boolean> WEIGHT_ON_WHEELS =
      SCHEMA.flag("weightOnWheels");
  private static final ValueField<AircraftState, Boolean> ENGINE_STARTING =
      SCHEMA.flag("engineStarting");
  private static final ValueField<AircraftState, Boolean> CRASHED = SCHEMA.flag("crashed");

  public static final MessageType<AircraftState> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends AircraftState> type() {
    return TYPE;
  }

  /**
   * Height of the aircraft's reference point above the ground below [m, up]; 0…1.5 when on its
   * wheels; empty if unknown.
   */
  public OptionalDouble heightAboveGround() {
    return get(HEIGHT_ABOVE_GROUND);
  }

  public AircraftState heightAboveGround(double metres) {
    return put(HEIGHT_ABOVE_GROUND, metres);
  }

  /** Calibrated airspeed, as shown by an ideal airspeed indicator [m/s]; empty if unknown. */
  public OptionalDouble calibratedAirspeed() {
    return get(CALIBRATED_AIRSPEED);
  }

  /** Sets {@link #calibratedAirspeed()}; not negative. */
  public AircraftState calibratedAirspeed(double metresPerSecond) {
    return put(CALIBRATED_AIRSPEED, metresPerSecond);
  }

  /** Engine speed [1/min]; empty if unknown. */
  public OptionalDouble engineRpm() {
    return get(ENGINE_RPM);
  }

  /** Sets {@link #engineRpm()}; not negative. */
  public AircraftState engineRpm(double perMinute) {
    return put(ENGINE_RPM, perMinute);
  }

  /** Whether a main wheel carries load; false until set. */
  public boolean weightOnWheels() {
    return get(WEIGHT_ON_WHEELS);
  }

  public AircraftState weightOnWheels(boolean value) {
    return put(WEIGHT_ON_WHEELS, value);
  }

  /** Whether the engine is being primed: throttle must stay within 0.1…0.5; false until set. */
  public boolean engineStarting() {
    return get(ENGINE_STARTING);
  }

  public AircraftState engineStarting(boolean value) {
    return put(ENGINE_STARTING, value);
  }

  /** Whether the aircraft is wrecked; false until set. */
  public boolean crashed() {
    return get(CRASHED);
  }

  public AircraftState crashed(boolean value) {
    return put(CRASHED, value);
  }

  @Override
  public AircraftState copy() {
    return (AircraftState) super.copy();
  }
}
