package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;

/** Waypoints straight above a vehicle that can hover and drifts by some centimetres. */
class VerticalLegTest extends PlannedVehicle {
  private static final double STEP_S = 0.1;

  /** Rises, and publishes states for a while. */
  private void rise(double metresPerS, double seconds) {
    kit.start(PathPlanner::new);
    goals(waypoint("top", 0.03, 0.0).z(-20.0).verticalThreshold(1.0).horizontalThreshold(2.0));
    for (int i = 0; i * STEP_S < seconds; i++) {
      kit.advance(STEP_S);
      double upM = Math.min(20.0, metresPerS * i * STEP_S);
      kit.publish(Channels.STATE, state(0.1 * Math.sin(0.5 * i), 0.0, 0.0).z(-upM));
    }
  }

  @Test
  void state_waypointStraightAbove_isReachedAtItsAltitudeAndNotMissedBefore() {
    rise(1.0, 25.0);

    assertThat(kit.published(Channels.GOAL_REPORTS).get(0).completed()).isTrue();
    assertThat(logged("missed")).isZero();
  }

  @Test
  void state_waypointStraightAboveButNoClimb_isGivenUp() {
    rise(0.0, 60.0);

    assertThat(kit.published(Channels.GOAL_REPORTS).get(0).abandoned()).isTrue();
  }
}
