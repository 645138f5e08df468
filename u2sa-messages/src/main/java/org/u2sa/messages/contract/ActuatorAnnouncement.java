package org.u2sa.messages.contract;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * An actuator's capabilities (thesis 3.2.3.5, 5.1): limits, dynamics, and its effect on the
 * vehicle's six degrees of freedom, so that control can allocate to actuators it does not know in
 * advance.
 *
 * <p>Forces and moments are along and about forward, right and down axes (BODY_FRD) through the
 * vehicle's reference point. At u percent the effect is force · (|u|/100)^{@link #exponent}; below
 * 0 the same with {@link #reverseForce} and {@link #reverseMoment}.
 */
public final class ActuatorAnnouncement extends U2SAData {
  private static final Schema<ActuatorAnnouncement> SCHEMA =
      Schema.of(ActuatorAnnouncement.class, ActuatorAnnouncement::new, U2SAData.TYPE);
  private static final ValueField<ActuatorAnnouncement, String> ACTUATOR_NAME =
      SCHEMA.requiredName("actuatorName");
  private static final NumberField<ActuatorAnnouncement> MINIMUM =
      SCHEMA.requiredNumber("minimum", "%", -100.0, 100.0);
  private static final NumberField<ActuatorAnnouncement> MAXIMUM =
      SCHEMA.requiredNumber("maximum", "%", -100.0, 100.0);
  private static final ValueField<ActuatorAnnouncement, String> EFFECT = SCHEMA.text("effect", "");
  private static final ValueField<ActuatorAnnouncement, String> SUBSYSTEM =
      SCHEMA.name("subsystem", "VEHICLE");
  private static final NumberField<ActuatorAnnouncement> RATE_LIMIT =
      SCHEMA.since(3).optionalNumber("rateLimit", "%/s", 0.0);
  private static final NumberField<ActuatorAnnouncement> DEADBAND =
      SCHEMA.optionalNumber("deadband", "%", 0.0, 99.0);
  private static final NumberField<ActuatorAnnouncement> TIME_CONSTANT =
      SCHEMA.optionalNumber("timeConstant", "s", 0.0);
  private static final ValueField<ActuatorAnnouncement, Point> FORCE =
      SCHEMA.optionalPoint("force", "N");
  private static final ValueField<ActuatorAnnouncement, Point> MOMENT =
      SCHEMA.optionalPoint("moment", "N m");
  private static final ValueField<ActuatorAnnouncement, Point> REVERSE_FORCE =
      SCHEMA.optionalPoint("reverseForce", "N");
  private static final ValueField<ActuatorAnnouncement, Point> REVERSE_MOMENT =
      SCHEMA.optionalPoint("reverseMoment", "N m");
  private static final NumberField<ActuatorAnnouncement> EXPONENT =
      SCHEMA.optionalNumber("exponent", "", 0.1, 10.0);
  private static final NumberField<ActuatorAnnouncement> REFERENCE_SPEED =
      SCHEMA.optionalNumber("referenceSpeed", "m/s", 0.0);
  private static final NumberField<ActuatorAnnouncement> FULL_ANGLE =
      SCHEMA.optionalNumber("fullAngle", "rad");
  private static final NumberField<ActuatorAnnouncement> FULL_SPEED =
      SCHEMA.optionalNumber("fullSpeed", "rad/s");
  private static final NumberField<ActuatorAnnouncement> AVAILABLE =
      SCHEMA.optionalNumber("available", "%", 0.0, 100.0);
  private static final NumberField<ActuatorAnnouncement> RENEWAL =
      SCHEMA.optionalNumber("renewal", "s", 0.0);
  private static final ValueField<ActuatorAnnouncement, String> SERVICE_NAME =
      SCHEMA.optionalName("serviceName");
  private static final ValueField<ActuatorAnnouncement, List<String>> COMMAND_TYPES =
      SCHEMA.optionalTexts("commandTypes");
  private static final ValueField<ActuatorAnnouncement, Boolean> WITHHELD =
      SCHEMA.optionalFlag("withheld");
  private static final NumberField<ActuatorAnnouncement> PERCENTAGE =
      SCHEMA.optionalNumber("percentage", "%", -100.0, 100.0);

  public static final MessageType<ActuatorAnnouncement> TYPE = SCHEMA.build();

  @Override
  public MessageType<ActuatorAnnouncement> type() {
    return TYPE;
  }

  /** Name of the actuator. */
  public String actuatorName() {
    return require(ACTUATOR_NAME);
  }

  public ActuatorAnnouncement actuatorName(String value) {
    return put(ACTUATOR_NAME, value);
  }

  /** Minimum percentage [%]. */
  public double minimum() {
    return require(MINIMUM);
  }

  public ActuatorAnnouncement minimum(double value) {
    return put(MINIMUM, value);
  }

  /** Maximum percentage [%]. */
  public double maximum() {
    return require(MAXIMUM);
  }

  public ActuatorAnnouncement maximum(double value) {
    return put(MAXIMUM, value);
  }

  /** Effect on the vehicle, in words. */
  public String effect() {
    return require(EFFECT);
  }

  public ActuatorAnnouncement effect(String value) {
    return put(EFFECT, value);
  }

  /** Subsystem that it moves; defaults to "VEHICLE". */
  public String subsystem() {
    return require(SUBSYSTEM);
  }

  public ActuatorAnnouncement subsystem(String value) {
    return put(SUBSYSTEM, value);
  }

  /** Slew-rate limit [%/s]; empty: practically instantaneous. */
  public OptionalDouble rateLimit() {
    return get(RATE_LIMIT);
  }

  public ActuatorAnnouncement rateLimit(double value) {
    return put(RATE_LIMIT, value);
  }

  /** Dead band [%, 0…99]: a command's effect is zero up to it and grows from there; empty: 0. */
  public OptionalDouble deadband() {
    return get(DEADBAND);
  }

  public ActuatorAnnouncement deadband(double value) {
    return put(DEADBAND, value);
  }

  /** Time constant of its first-order response [s]; empty: unknown. */
  public OptionalDouble timeConstant() {
    return get(TIME_CONSTANT);
  }

  public ActuatorAnnouncement timeConstant(double value) {
    return put(TIME_CONSTANT, value);
  }

  /**
   * Force on the vehicle at +100 %: forward, right, down [N]; empty: unknown, or zero if a moment
   * is given.
   */
  public Optional<Point> force() {
    return Optional.ofNullable(get(FORCE));
  }

  public ActuatorAnnouncement force(Point value) {
    return put(FORCE, value);
  }

  /**
   * Moment on the vehicle at +100 %: rolling right, pitching up, yawing right [N m]; empty:
   * unknown, or zero if a force is given.
   */
  public Optional<Point> moment() {
    return Optional.ofNullable(get(MOMENT));
  }

  public ActuatorAnnouncement moment(Point value) {
    return put(MOMENT, value);
  }

  /** Force at −100 % [N]; empty: opposite to {@link #force()}. */
  public Optional<Point> reverseForce() {
    return Optional.ofNullable(get(REVERSE_FORCE));
  }

  public ActuatorAnnouncement reverseForce(Point value) {
    return put(REVERSE_FORCE, value);
  }

  /** Moment at −100 % [N m]; empty: opposite to {@link #moment()}. */
  public Optional<Point> reverseMoment() {
    return Optional.ofNullable(get(REVERSE_MOMENT));
  }

  public ActuatorAnnouncement reverseMoment(Point value) {
    return put(REVERSE_MOMENT, value);
  }

  /**
   * Exponent of the effect over the command's fraction of 100 % [0.1…10]; empty: 1. About 2 for
   * propellers.
   */
  public OptionalDouble exponent() {
    return get(EXPONENT);
  }

  public ActuatorAnnouncement exponent(double value) {
    return put(EXPONENT, value);
  }

  /**
   * Speed through air or water at which the effect was determined [m/s], for control surfaces,
   * whose effect grows with the speed squared; empty: independent of speed.
   */
  public OptionalDouble referenceSpeed() {
    return get(REFERENCE_SPEED);
  }

  public ActuatorAnnouncement referenceSpeed(double value) {
    return put(REFERENCE_SPEED, value);
  }

  /** Angle at +100 % [rad], the scale of AngleCommand; empty: not applicable. */
  public OptionalDouble fullAngle() {
    return get(FULL_ANGLE);
  }

  public ActuatorAnnouncement fullAngle(double value) {
    return put(FULL_ANGLE, value);
  }

  /** Rotational speed at +100 % [rad/s], the scale of SpeedCommand; empty: not applicable. */
  public OptionalDouble fullSpeed() {
    return get(FULL_SPEED);
  }

  public ActuatorAnnouncement fullSpeed(double value) {
    return put(FULL_SPEED, value);
  }

  /**
   * Remaining fraction of the announced effect [%, 0…100]: 0 if the actuator is withdrawn; empty:
   * 100.
   */
  public OptionalDouble available() {
    return get(AVAILABLE);
  }

  public ActuatorAnnouncement available(double value) {
    return put(AVAILABLE, value);
  }

  /**
   * Whether the actuator is sound but does not carry out commands for now, because a pilot's radio
   * or an emergency stop has precedence. False from senders that predate the field.
   */
  public boolean withheld() {
    return Boolean.TRUE.equals(get(WITHHELD));
  }

  public ActuatorAnnouncement withheld(boolean value) {
    return put(WITHHELD, value);
  }

  /** Level of the position that a switched payload has taken [%]; empty: it does not report it. */
  public OptionalDouble percentage() {
    return get(PERCENTAGE);
  }

  public ActuatorAnnouncement percentage(double value) {
    return put(PERCENTAGE, value);
  }

  /**
   * Announcement period [s]: control drops an actuator after three periods of silence; empty: 5 s.
   */
  public OptionalDouble renewal() {
    return get(RENEWAL);
  }

  public ActuatorAnnouncement renewal(double value) {
    return put(RENEWAL, value);
  }

  /** Simple names of the command classes it accepts besides PercentageCommand; empty if none. */
  public List<String> commandTypes() {
    List<String> types = get(COMMAND_TYPES);
    return types == null ? List.of() : types;
  }

  public ActuatorAnnouncement commandTypes(List<String> value) {
    return put(COMMAND_TYPES, List.copyOf(value));
  }

  /**
   * Service that drives it; the service's health reports and loss of connection also apply to the
   * actuator. Empty if unknown.
   */
  public Optional<String> serviceName() {
    return Optional.ofNullable(get(SERVICE_NAME));
  }

  public ActuatorAnnouncement serviceName(String value) {
    return put(SERVICE_NAME, value);
  }
}
