package org.u2sa.drivers.mavlink;

import io.dronefleet.mavlink.common.MavFrame;
import io.dronefleet.mavlink.common.PositionTargetTypemask;
import io.dronefleet.mavlink.common.SetPositionTargetLocalNed;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;

/**
 * Commands as body velocities and yaw rate: SET_POSITION_TARGET_LOCAL_NED in BODY_NED, for
 * ArduPilot's Guided and PX4's Offboard mode. Neutral is zero velocity.
 */
final class VelocityTarget implements CommandForm {
  static final String FORWARD = "FORWARD SPEED";
  static final String LEFT = "LEFT SPEED";
  static final String CLIMB = "CLIMB SPEED";
  static final String TURN = "TURN RATE";

  private static final double FULL_PERCENT = 100.0;
  // MAV_FRAME_BODY_NED: deprecated, but the one both ArduPilot and PX4 accept.
  private static final EnumValue<MavFrame> BODY_NED = EnumValue.create(8);

  // Bits 0…2 ignore position, 6…8 acceleration, 10 yaw, leaving velocity and yaw rate.
  private static final EnumValue<PositionTargetTypemask> VELOCITY_AND_YAW_RATE =
      EnumValue.create(0b101_1100_0111);

  private final double fullMps;
  private final double fullClimbMps;
  private final double fullTurnRadPerS;

  /**
   * @param fullMps speed forward and to the left at 100 % [m/s]
   * @param fullClimbMps climb rate at 100 % [m/s]
   * @param fullTurnRadPerS left yaw rate at 100 % [rad/s]
   */
  VelocityTarget(double fullMps, double fullClimbMps, double fullTurnRadPerS) {
    this.fullMps = fullMps;
    this.fullClimbMps = fullClimbMps;
    this.fullTurnRadPerS = fullTurnRadPerS;
  }

  @Override
  public List<Axis> axes() {
    return List.of(
        new Axis(FORWARD, -FULL_PERCENT, "speed forward"),
        new Axis(LEFT, -FULL_PERCENT, "speed to the left"),
        new Axis(CLIMB, -FULL_PERCENT, "speed upwards"),
        new Axis(TURN, -FULL_PERCENT, "turns to the left"));
  }

  @Override
  public Object message(
      Target target, Function<String, OptionalDouble> percentages, long nowMicros) {
    return SetPositionTargetLocalNed.builder()
        .targetSystem(target.systemId())
        .targetComponent(target.componentId())
        .coordinateFrame(BODY_NED)
        .typeMask(VELOCITY_AND_YAW_RATE)
        .vx((float) (fullMps * CommandForm.share(percentages, FORWARD)))
        .vy((float) (-fullMps * CommandForm.share(percentages, LEFT))) // MAVLink: to the right
        .vz((float) (-fullClimbMps * CommandForm.share(percentages, CLIMB))) // MAVLink: down
        .yawRate(
            (float)
                (-fullTurnRadPerS * CommandForm.share(percentages, TURN))) // MAVLink: to the right
        .build();
  }
}
