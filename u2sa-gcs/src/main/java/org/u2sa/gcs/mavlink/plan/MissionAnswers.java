package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MavSeverity;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.Map;
import java.util.TreeMap;
import org.u2sa.gcs.mavlink.station.GroundStation;
import org.u2sa.gcs.mavlink.station.GroundStation.Sender;

/** Acknowledgements to one station, with reasons as texts. */
final class MissionAnswers {
  static final int MISSION = MavMissionType.MAV_MISSION_TYPE_MISSION.ordinal();
  static final int FENCE = MavMissionType.MAV_MISSION_TYPE_FENCE.ordinal();

  static final int RALLY = MavMissionType.MAV_MISSION_TYPE_RALLY.ordinal();

  private final GroundStation station;
  private final Map<Integer, MissionAck> newest = new TreeMap<>(); // by MAV_MISSION_TYPE

  MissionAnswers(GroundStation station) {
    this.station = station;
  }

  GroundStation station() {
    return station;
  }

  /**
   * @param type MAV_MISSION_TYPE
   */
  void acknowledge(MavMissionResult result, int type, Sender to) {
    MissionAck answer =
        MissionAck.builder()
            .targetSystem(to.system())
            .targetComponent(to.component())
            .type(result)
            .missionType(EnumValue.create(MavMissionType.class, type))
            .build();
    newest.put(type, answer);
    station.send(answer);
  }

  /** Forgets earlier acknowledgements when an upload starts. */
  void forget(int type) {
    newest.remove(type);
  }

  /** Sends the newest acknowledgement again, if it went to that sender. */
  void repeat(int type, Sender to) {
    MissionAck answer = newest.get(type);
    if (answer != null
        && answer.targetSystem() == to.system()
        && answer.targetComponent() == to.component()) {
      station.send(answer);
    }
  }

  void refuse(MavMissionResult result, String why, int type, Sender to) {
    station.text(MavSeverity.MAV_SEVERITY_ERROR, why);
    acknowledge(result, type, to);
  }

  void warn(String text) {
    station.text(MavSeverity.MAV_SEVERITY_WARNING, text);
  }

  /** Refuses items that are neither mission, fence nor rally points. */
  void refuseType(int type, Sender to) {
    acknowledge(MavMissionResult.MAV_MISSION_UNSUPPORTED, type, to);
  }
}
