package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavMissionResult;

/** A mission that cannot be expressed in the other system; the message names what and why. */
final class PlanRefusal extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final MavMissionResult result;

  PlanRefusal(MavMissionResult result, String message) {
    super(message);
    this.result = result;
  }

  MavMissionResult result() {
    return result;
  }
}
