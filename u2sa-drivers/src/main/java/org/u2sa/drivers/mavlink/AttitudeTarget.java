package org.u2sa.drivers.mavlink;

import io.dronefleet.mavlink.common.Attitude;
import io.dronefleet.mavlink.common.AttitudeTargetTypemask;
import io.dronefleet.mavlink.common.SetAttitudeTarget;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;
import org.u2sa.interfaces.time.Clock;

/**
 * Commands as roll, pitch, yaw rate and thrust: SET_ATTITUDE_TARGET. Neutral is level attitude,
 * current heading and neutral thrust.
 *
 * <p>Yaw rate is sent as a heading that advances from the vehicle's own, because ArduCopter stops
 * on a message with only some body rates and treats the quaternion's yaw as a compass heading. An
 * attitude without rates is interpreted identically by all ArduCopter versions, ArduPlane, Rover
 * and PX4 (docs/drivers/mavlink.md).
 */
final class AttitudeTarget implements CommandForm {
  static final String ROLL = "ROLL ANGLE";
  static final String PITCH = "PITCH ANGLE";
  static final String YAW = "YAW RATE";
  static final String THRUST = "THRUST";

  private static final double FULL_PERCENT = 100.0;
  // Bits 0, 1 and 2 ignore roll, pitch and yaw rates, leaving the angles.
  private static final EnumValue<AttitudeTargetTypemask> ANGLES = EnumValue.create(0b111);
  private static final long NEVER = Long.MIN_VALUE / 2;
  private static final long FRESH_MICROS = Clock.micros(1.0);
  private static final double MAX_LEAD_RAD =
      0.5; // bounds the lead over a vehicle that cannot follow

  private final double fullTiltRad;
  private final double fullYawRadPerS;
  private final double neutralThrust;
  private double vehicleRad; // heading, clockwise from true north
  private long vehicleMicros = NEVER;
  private double targetRad;
  private long targetMicros = NEVER;

  /**
   * @param fullTiltRad roll, right wing down, and pitch, nose up, at 100 % [rad]
   * @param fullYawRadPerS rate of yaw to the right at 100 % [rad/s]
   * @param neutralThrust thrust without a command, 0…1
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
  public void hear(Attitude attitude, long nowMicros) {
    if (Float.isFinite(attitude.yaw())) {
      vehicleRad = attitude.yaw();
      vehicleMicros = nowMicros;
    }
  }

  @Override
  public boolean isReady(long nowMicros) {
    return nowMicros - vehicleMicros <= FRESH_MICROS || isTurning(nowMicros);
  }

  /** Whether a target heading exists. */
  private boolean isTurning(long nowMicros) {
    return nowMicros - targetMicros <= FRESH_MICROS;
  }

  @Override
  public Object message(
      Target target, Function<String, OptionalDouble> percentages, long nowMicros) {
    turn(fullYawRadPerS * CommandForm.share(percentages, YAW), nowMicros);
    double thrust = percentages.apply(THRUST).orElse(neutralThrust * FULL_PERCENT) / FULL_PERCENT;
    return SetAttitudeTarget.builder()
        .targetSystem(target.systemId())
        .targetComponent(target.componentId())
        .typeMask(ANGLES)
        .q(
            quaternion(
                fullTiltRad * CommandForm.share(percentages, ROLL),
                fullTiltRad * CommandForm.share(percentages, PITCH),
                targetRad))
        .thrust((float) Math.max(0.0, thrust))
        .thrustBody(List.of(0.0f, 0.0f, 0.0f))
        .build();
  }

  private void turn(double yawRadPerS, long nowMicros) {
    if (isTurning(nowMicros)) {
      targetRad += yawRadPerS * Clock.seconds(nowMicros - targetMicros);
    } else {
      targetRad = vehicleRad;
    }
    targetMicros = nowMicros;
    if (nowMicros - vehicleMicros <= FRESH_MICROS) {
      double lead = Math.IEEEremainder(targetRad - vehicleRad, 2.0 * Math.PI);
      targetRad = vehicleRad + Math.max(-MAX_LEAD_RAD, Math.min(MAX_LEAD_RAD, lead));
    }
  }

  /** w, x, y, z of yaw, then pitch, then roll (Stevens and Lewis, 2nd ed., eq. 1.3-33). */
  private static List<Float> quaternion(double roll, double pitch, double yaw) {
    double cosRoll = Math.cos(roll / 2.0);
    double sinRoll = Math.sin(roll / 2.0);
    double cosPitch = Math.cos(pitch / 2.0);
    double sinPitch = Math.sin(pitch / 2.0);
    double cosYaw = Math.cos(yaw / 2.0);
    double sinYaw = Math.sin(yaw / 2.0);
    return List.of(
        (float) (cosRoll * cosPitch * cosYaw + sinRoll * sinPitch * sinYaw),
        (float) (sinRoll * cosPitch * cosYaw - cosRoll * sinPitch * sinYaw),
        (float) (cosRoll * sinPitch * cosYaw + sinRoll * cosPitch * sinYaw),
        (float) (cosRoll * cosPitch * sinYaw - sinRoll * sinPitch * cosYaw));
  }
}
