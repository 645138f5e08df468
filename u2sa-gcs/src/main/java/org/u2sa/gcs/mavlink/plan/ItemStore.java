package org.u2sa.gcs.mavlink.plan;

import java.util.List;
import org.u2sa.gcs.mavlink.station.GroundStation.Sender;

/** The object represented by the items of one MAV_MISSION_TYPE. */
interface ItemStore {
  /**
   * The present items.
   *
   * @throws PlanRefusal if items cannot express them
   */
  List<MissionItem> listed();

  /** Whether an item is the one being pursued. */
  default boolean isCurrent(int seq) {
    return false;
  }

  /** Replaces all items, and acknowledges. */
  void replace(List<MissionItem> items, Sender from);

  /**
   * Removes all items, and acknowledges.
   *
   * @param type MAV_MISSION_TYPE of the acknowledgement
   */
  void clear(int type, Sender from);
}
