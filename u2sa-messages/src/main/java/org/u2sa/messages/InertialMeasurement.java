package org.u2sa.messages;

import java.util.OptionalDouble;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/**
 * Raw measurements of gyroscopes and accelerometers: angular rates about and specific force along
 * the vehicle's axes, in BODY_FRD unless {@link #referenceFrame} is BODY or BODY_FLU. These are not
 * the Euler angle rates and ground accelerations of {@link StateInformation}; other outputs of an
 * inertial sensor (attitude, for example) go into those fields of a separate message. A reader that
 * does not know this class receives a StateInformation.
 */
public class InertialMeasurement extends StateInformation {
  private static final Schema<InertialMeasurement> SCHEMA =
      Schema.of(InertialMeasurement.class, InertialMeasurement::blank, StateInformation.TYPE);
  private static final NumberField<InertialMeasurement> ROLL_RATE =
      SCHEMA.since(3).optionalNumber("rollRate", "rad/s");
  private static final NumberField<InertialMeasurement> PITCH_RATE =
      SCHEMA.optionalNumber("pitchRate", "rad/s");
  private static final NumberField<InertialMeasurement> YAW_RATE =
      SCHEMA.optionalNumber("yawRate", "rad/s");
  private static final NumberField<InertialMeasurement> ANGULAR_RATE_SIGMA =
      SCHEMA.optionalNumber("angularRateSigma", "rad/s", 0.0);
  private static final NumberField<InertialMeasurement> SPECIFIC_FORCE_X =
      SCHEMA.optionalNumber("specificForceX", "m/s2");
  private static final NumberField<InertialMeasurement> SPECIFIC_FORCE_Y =
      SCHEMA.optionalNumber("specificForceY", "m/s2");
  private static final NumberField<InertialMeasurement> SPECIFIC_FORCE_Z =
      SCHEMA.optionalNumber("specificForceZ", "m/s2");
  private static final NumberField<InertialMeasurement> SPECIFIC_FORCE_SIGMA =
      SCHEMA.optionalNumber("specificForceSigma", "m/s2", 0.0);

  public static final MessageType<InertialMeasurement> TYPE = SCHEMA.build();

  /** Creates an empty measurement in BODY_FRD. */
  public InertialMeasurement() {
    referenceFrame(ReferenceFrame.BODY_FRD);
  }

  private InertialMeasurement(@SuppressWarnings("unused") Void nothingSet) {}

  /** Creates an instance for a reader or a copy, each of which sets every field once. */
  private static InertialMeasurement blank() {
    return new InertialMeasurement(null);
  }

  @Override
  public MessageType<? extends InertialMeasurement> type() {
    return TYPE;
  }

  /** Angular rate about the x (forward) axis [rad/s]; positive right side down in BODY_FRD. */
  public OptionalDouble rollRate() {
    return get(ROLL_RATE);
  }

  public InertialMeasurement rollRate(double radPerS) {
    return put(ROLL_RATE, radPerS);
  }

  /** Angular rate about the y axis [rad/s]; positive nose up in BODY_FRD. */
  public OptionalDouble pitchRate() {
    return get(PITCH_RATE);
  }

  public InertialMeasurement pitchRate(double radPerS) {
    return put(PITCH_RATE, radPerS);
  }

  /** Angular rate about the z axis [rad/s]; positive nose right in BODY_FRD. */
  public OptionalDouble yawRate() {
    return get(YAW_RATE);
  }

  public InertialMeasurement yawRate(double radPerS) {
    return put(YAW_RATE, radPerS);
  }

  /** Standard deviation of each angular rate [rad/s]; empty if unknown. */
  public OptionalDouble angularRateSigma() {
    return get(ANGULAR_RATE_SIGMA);
  }

  public InertialMeasurement angularRateSigma(double radPerS) {
    return put(ANGULAR_RATE_SIGMA, radPerS);
  }

  /**
   * Specific force along x [m/s²]: acceleration minus gravity, as an accelerometer reads; positive
   * when accelerating forward.
   */
  public OptionalDouble specificForceX() {
    return get(SPECIFIC_FORCE_X);
  }

  public InertialMeasurement specificForceX(double mps2) {
    return put(SPECIFIC_FORCE_X, mps2);
  }

  /** Specific force along y [m/s²]; positive right in BODY_FRD. */
  public OptionalDouble specificForceY() {
    return get(SPECIFIC_FORCE_Y);
  }

  public InertialMeasurement specificForceY(double mps2) {
    return put(SPECIFIC_FORCE_Y, mps2);
  }

  /** Specific force along z [m/s²]; -9.81 at rest and level in BODY_FRD, whose z is down. */
  public OptionalDouble specificForceZ() {
    return get(SPECIFIC_FORCE_Z);
  }

  public InertialMeasurement specificForceZ(double mps2) {
    return put(SPECIFIC_FORCE_Z, mps2);
  }

  /** Standard deviation of each component of specific force [m/s²]; empty if unknown. */
  public OptionalDouble specificForceSigma() {
    return get(SPECIFIC_FORCE_SIGMA);
  }

  public InertialMeasurement specificForceSigma(double mps2) {
    return put(SPECIFIC_FORCE_SIGMA, mps2);
  }

  @Override
  void flipOwn(TranslationState<?> copy, BodySigns signs) {
    InertialMeasurement turned = (InertialMeasurement) copy;
    rollRate().ifPresent(rate -> turned.rollRate(signs.phi() * rate));
    pitchRate().ifPresent(rate -> turned.pitchRate(signs.theta() * rate));
    yawRate().ifPresent(rate -> turned.yawRate(signs.psi() * rate));
    specificForceY().ifPresent(force -> turned.specificForceY(signs.y() * force));
    specificForceZ().ifPresent(force -> turned.specificForceZ(signs.z() * force));
  }
}
