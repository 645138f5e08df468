package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavFrame;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.util.EnumValue;
import org.u2sa.gcs.mavlink.station.GroundStation;

/**
 * A mission item as it travels (MISSION_ITEM_INT); equal items are equal on the wire.
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
  static final int WAYPOINT = 16;
  static final int LOITER_UNLIMITED = 17;
  static final int LOITER_TIME = 19;
  static final int RETURN = 20;
  static final int TAKE_OFF = 22;
  static final int JUMP = 177;
  static final int CHANGE_SPEED = 178;

  static final int GLOBAL = 0;
  static final int GLOBAL_RELATIVE = 3;
  static final int GLOBAL_INT = 5;
  static final int GLOBAL_RELATIVE_INT = 6;
  static final int MISSION_FRAME = 2;

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

  /** An item at a place with no other parameters. */
  static MissionItem at(int frame, int command, double latitudeDeg, double longitudeDeg, double z) {
    return new MissionItem(
        frame,
        command,
        1,
        0.0f,
        0.0f,
        0.0f,
        Float.NaN,
        (int) Math.round(latitudeDeg * PER_DEGREE),
        (int) Math.round(longitudeDeg * PER_DEGREE),
        (float) z);
  }

  /** An item that is not a place. */
  static MissionItem action(int command, float param1, float param2) {
    return new MissionItem(MISSION_FRAME, command, 1, param1, param2, 0.0f, 0.0f, 0, 0, 0.0f);
  }

  MissionItem with(float first, float second, float fourth) {
    return new MissionItem(frame, command, autocontinue, first, second, param3, fourth, x, y, z);
  }

  MissionItemInt message(int seq, boolean isCurrent, GroundStation.Sender to) {
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
        .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION)
        .build();
  }

  double latitudeDeg() {
    return x / PER_DEGREE;
  }

  double longitudeDeg() {
    return y / PER_DEGREE;
  }

  /** Whether it has a horizontal position; 0/0 means none. */
  boolean hasPlace() {
    return x != 0 || y != 0;
  }
}
