package org.u2sa.messages.contract;

import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** An actuator says what it can do (thesis 3.2.3.5, 5.1). */
public final class ActuatorAnnouncement extends U2SAData {
  private static final Schema<ActuatorAnnouncement> SCHEMA =
      Schema.of(ActuatorAnnouncement.class, ActuatorAnnouncement::new, U2SAData.TYPE);
  private static final ValueField<ActuatorAnnouncement, String> ACTUATOR_NAME =
      SCHEMA.requiredText("actuatorName");
  private static final NumberField<ActuatorAnnouncement> MINIMUM =
      SCHEMA.requiredNumber("minimum", "%", -100.0, 100.0);
  private static final NumberField<ActuatorAnnouncement> MAXIMUM =
      SCHEMA.requiredNumber("maximum", "%", -100.0, 100.0);
  private static final ValueField<ActuatorAnnouncement, String> EFFECT = SCHEMA.text("effect", "");
  private static final ValueField<ActuatorAnnouncement, String> SUBSYSTEM =
      SCHEMA.text("subsystem", "VEHICLE");

  /** The schema. */
  public static final MessageType<ActuatorAnnouncement> TYPE = SCHEMA.build();

  @Override
  public MessageType<ActuatorAnnouncement> type() {
    return TYPE;
  }

  /** The actuator. */
  public String actuatorName() {
    return require(ACTUATOR_NAME);
  }

  /** Sets {@link #actuatorName()}. */
  public ActuatorAnnouncement actuatorName(String value) {
    return put(ACTUATOR_NAME, value);
  }

  /** Smallest percentage it takes [%]. */
  public double minimum() {
    return require(MINIMUM);
  }

  /** Sets {@link #minimum()}. */
  public ActuatorAnnouncement minimum(double value) {
    return put(MINIMUM, value);
  }

  /** Largest percentage it takes [%]. */
  public double maximum() {
    return require(MAXIMUM);
  }

  /** Sets {@link #maximum()}. */
  public ActuatorAnnouncement maximum(double value) {
    return put(MAXIMUM, value);
  }

  /** What moving it does to the vehicle, in words. */
  public String effect() {
    return require(EFFECT);
  }

  /** Sets {@link #effect()}. */
  public ActuatorAnnouncement effect(String value) {
    return put(EFFECT, value);
  }

  /** The part of the vehicle that it moves; "VEHICLE" until set. */
  public String subsystem() {
    return require(SUBSYSTEM);
  }

  /** Sets {@link #subsystem()}. */
  public ActuatorAnnouncement subsystem(String value) {
    return put(SUBSYSTEM, value);
  }
}
