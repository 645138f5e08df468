package org.u2sa.drivers.mavlink;

import io.dronefleet.mavlink.common.AttitudeTargetTypemask;
import io.dronefleet.mavlink.common.SetAttitudeTarget;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;

/**
 * Commands as roll and pitch angles, rate of yaw and thrust: SET_ATTITUDE_TARGET. Neutral is level,
 * without yaw, at the neutral thrust.
 */
final class AttitudeTarget implements CommandForm {
  static final String ROLL = "ROLL ANGLE";
  static final String PITCH = "PITCH ANGLE";
  static final String YAW = "YAW RATE";
  static final String THRUST = "THRUST";

  private static final double FULL_PERCENT = 100.0;
  // Bits 0 and 1 ignore the rates of roll and pitch: angles and the rate of yaw are left.
  private static final EnumValue<AttitudeTargetTypemask> ANGLES_AND_YAW_RATE =
      EnumValue.create(0b11);

  private final double fullTiltRad;
  private final double fullYawRadPerS;
  private final double neutralThrust;

  /**
   * @param fullTiltRad roll, right wing down, and pitch, nose up, at 100 % [rad]
   * @param fullYawRadPerS rate of yaw to the right at 100 % [rad/s]
   * @param neutralThrust 0…1, where nothing is commanded
   */
  AttitudeTarget(double fullTiltRad, double fullYawRadPerS, double neutralThrust) {
    this.fullTiltRad = fullTiltRad;
    this.fullYawRadPerS = fullYawRadPerS;
    this.neutralThrust = neutralThrust;
  }

  @Override
  public List<Axis> axes() {
    return List.of(
        new Axis(ROLL, -FULL_PERCENT, "lowers the right wing"),
        new Axis(PITCH, -FULL_PERCENT, "raises the nose"),
        new Axis(YAW, -FULL_PERCENT, "turns the nose to the right"),
        new Axis(THRUST, 0.0, "thrust"));
  }

  @Override
  public Object message(Target target, Function<String, OptionalDouble> percentages) {
    double thrust = percentages.apply(THRUST).orElse(neutralThrust * FULL_PERCENT) / FULL_PERCENT;
    return SetAttitudeTarget.builder()
        .targetSystem(target.systemId())
        .targetComponent(target.componentId())
        .typeMask(ANGLES_AND_YAW_RATE)
        .q(
            quaternion(
                fullTiltRad * share(percentages, ROLL), fullTiltRad * share(percentages, PITCH)))
        .bodyYawRate((float) (fullYawRadPerS * share(percentages, YAW)))
        .thrust((float) Math.max(0.0, thrust))
        .thrustBody(List.of(0.0f, 0.0f, 0.0f))
        .build();
  }

  private static double share(Function<String, OptionalDouble> percentages, String axis) {
    return percentages.apply(axis).orElse(0.0) / FULL_PERCENT;
  }

  /** w, x, y, z of pitch, then roll, without yaw (Stevens and Lewis, 2nd ed., section 1.2). */
  private static List<Float> quaternion(double roll, double pitch) {
    double cosRoll = Math.cos(roll / 2.0);
    double sinRoll = Math.sin(roll / 2.0);
    double cosPitch = Math.cos(pitch / 2.0);
    double sinPitch = Math.sin(pitch / 2.0);
    return List.of(
        (float) (cosRoll * cosPitch),
        (float) (sinRoll * cosPitch),
        (float) (cosRoll * sinPitch),
        (float) (-sinRoll * sinPitch));
  }

  @Override
  public List<Object> release(Target target) {
    return List.of();
  }
}
