package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavFrame;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.List;
import org.u2sa.gcs.mavlink.station.GroundStation;
import org.u2sa.gcs.plan.PlanItem;

/**
 * A mission item in wire format (MISSION_ITEM_INT); equal items are equal on the wire.
 *
 * @param frame MAV_FRAME
 * @param command MAV_CMD
 * @param x latitude [1e-7 deg], or a parameter
 * @param y longitude [1e-7 deg], or a parameter
 * @param z altitude [m], or a parameter
 */
record MissionItem(
    int frame,
    int command,
    int autocontinue,
    float param1,
    float param2,
    float param3,
    float param4,
    int x,
    int y,
    float z) {
  private static final double PER_DEGREE = 1.0e7;

  static MissionItem of(MissionItemInt item) {
    return new MissionItem(
        item.frame().value(),
        item.command().value(),
        item.autocontinue(),
        item.param1(),
        item.param2(),
        item.param3(),
        item.param4(),
        item.x(),
        item.y(),
        item.z());
  }

  /**
   * An item of a plan.
   *
   * @param first sequence number of the plan's item 1
   */
  static MissionItem of(PlanItem item, int first) {
    PlanItem plain = item.withNorth360();
    boolean jumps = item.command() == PlanItem.JUMP;
    return new MissionItem(
        item.frame(),
        item.command(),
        item.goesOn() ? 1 : 0,
        (float) (plain.parameter(1) + (jumps ? first - 1 : 0)),
        (float) plain.parameter(2),
        (float) plain.parameter(3),
        (float) plain.parameter(4),
        (int) Math.round(plain.parameter(5) * PER_DEGREE),
        (int) Math.round(plain.parameter(6) * PER_DEGREE),
        (float) plain.parameter(7));
  }

  /**
   * The item in the form of plans, which number items from 1.
   *
   * @param id its number
   * @param first sequence number of item 1
   */
  PlanItem planItem(int id, int first) {
    boolean jumps = command == PlanItem.JUMP;
    List<Double> parameters =
        List.of(
            decimal(param1) + (jumps ? 1 - first : 0),
            decimal(param2),
            decimal(param3),
            decimal(param4),
            latitudeDeg(),
            longitudeDeg(),
            decimal(z));
    return new PlanItem(command, frame, parameters, autocontinue != 0, id).withoutHeading0();
  }

  /** The shortest decimal number with this wire representation. */
  private static double decimal(float value) {
    return Double.parseDouble(Float.toString(value));
  }

  /**
   * @param type MAV_MISSION_TYPE
   */
  MissionItemInt message(int seq, boolean isCurrent, int type, GroundStation.Sender to) {
    return MissionItemInt.builder()
        .targetSystem(to.system())
        .targetComponent(to.component())
        .seq(seq)
        .frame(EnumValue.create(MavFrame.class, frame))
        .command(EnumValue.create(MavCmd.class, command))
        .current(isCurrent ? 1 : 0)
        .autocontinue(autocontinue)
        .param1(param1)
        .param2(param2)
        .param3(param3)
        .param4(param4)
        .x(x)
        .y(y)
        .z(z)
        .missionType(EnumValue.create(MavMissionType.class, type))
        .build();
  }

  double latitudeDeg() {
    return x / PER_DEGREE;
  }

  double longitudeDeg() {
    return y / PER_DEGREE;
  }
}
