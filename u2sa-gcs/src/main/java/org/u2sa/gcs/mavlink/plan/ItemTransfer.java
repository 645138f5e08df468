package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.List;
import org.u2sa.gcs.mavlink.station.GroundStation.Sender;

/** Items of one MAV_MISSION_TYPE, to and from one station. */
final class ItemTransfer {
  private final int type;
  private final String what;
  private final ItemStore store;
  private final MissionAnswers answers;
  private final MissionUpload upload;
  private List<MissionItem> outgoing = List.of(); // as they were when the list was requested

  /**
   * @param what name of the items in texts
   */
  ItemTransfer(int type, String what, ItemStore store, MissionAnswers answers) {
    this.type = type;
    this.what = what;
    this.store = store;
    this.answers = answers;
    upload = new MissionUpload(type, what, answers, store::replace);
  }

  /** Handles the station's request for the number of items. */
  void list(Sender from) {
    try {
      outgoing = store.listed();
    } catch (PlanRefusal e) {
      outgoing = List.of();
      answers.warn(what + " not shown: " + e.getMessage());
    }
    answers
        .station()
        .send(
            MissionCount.builder()
                .targetSystem(from.system())
                .targetComponent(from.component())
                .count(outgoing.size())
                .missionType(EnumValue.create(MavMissionType.class, type))
                .build());
  }

  /** Handles the station's request for one item. */
  void item(int seq, Sender from) {
    if (seq < 0 || seq >= outgoing.size()) {
      answers.acknowledge(MavMissionResult.MAV_MISSION_INVALID_SEQUENCE, type, from);
      return;
    }
    answers.station().send(outgoing.get(seq).message(seq, store.isCurrent(seq), type, from));
  }

  /** Handles the station's announcement of new items. */
  void begin(int count, Sender from) {
    if (count == 0) {
      store.clear(type, from);
    } else {
      upload.begin(count, from);
    }
  }

  /** Handles one item from the station. */
  void take(MissionItemInt item, Sender from) {
    upload.take(item, from);
  }

  /** Requests missing items again. */
  void step(long micros) {
    upload.step(micros);
  }
}
