package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavMissionResult;
import java.util.List;

/** A mission cannot be expressed in the other system; the message names the item and the reason. */
final class PlanRefusal extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final MavMissionResult result;

  PlanRefusal(MavMissionResult result, String message) {
    super(message);
    this.result = result;
  }

  /** The first of several reasons, for one line. */
  static String some(List<String> reasons) {
    int others = reasons.size() - 1;
    return reasons.get(0) + (others == 0 ? "" : " (and " + others + " more)");
  }

  MavMissionResult result() {
    return result;
  }
}
