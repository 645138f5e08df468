package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.goal.GoalInformation;

/** Waypoints straight above a vehicle that can hover and drifts by some centimetres. */
class VerticalLegTest extends PlannedVehicle {
  private static final double STEP_S = 0.1;

  /** Rises, and publishes states for a while. */
  private void rise(double metresPerS, double seconds, double topM) {
    kit.start(PathPlanner::new);
    goals(waypoint("top", 0.03, 0.0).z(-20.0).verticalThreshold(1.0).horizontalThreshold(2.0));
    for (int i = 0; i * STEP_S < seconds; i++) {
      kit.advance(STEP_S);
      double upM = Math.min(topM, metresPerS * i * STEP_S);
      kit.publish(Channels.OBJECTS, new ObjectList());
      kit.publish(Channels.STATE, state(0.1 * Math.sin(0.5 * i), 0.0, 0.0).z(-upM));
    }
  }

  @Test
  void state_waypointStraightAbove_isReachedAtItsAltitudeAndNotMissedBefore() {
    rise(1.0, 25.0, 20.0);

    assertThat(kit.published(Channels.GOAL_REPORTS).get(0).completed()).isTrue();
    assertThat(logged("missed")).isZero();
  }

  /** At the very edge, an estimation error of centimetres would make it a miss. */
  @ParameterizedTest
  @CsvSource({"NONE, 20", "GRID, 20", "NONE, 19.1"})
  void state_climbThroughTheEdgeOfTheVerticalThreshold_endsInsideOrWithTheClimb(
      String planner, double topM) {
    kit.with("PLANNER", planner).with("STUCK AFTER", 60.0);
    rise(1.0, 30.0, topM);

    GoalInformation report = kit.<GoalInformation>published(Channels.GOAL_REPORTS).get(0);
    assertThat(report.completed()).isTrue();
    assertThat(1e-6 * report.timestamp().orElseThrow())
        .isBetween(topM == 20.0 ? 19.2 : 23.0, topM == 20.0 ? 19.5 : 26.0);
  }

  @Test
  void state_waypointStraightAboveButNoClimb_isGivenUp() {
    rise(0.0, 60.0, 20.0);

    assertThat(kit.published(Channels.GOAL_REPORTS).get(0).abandoned()).isTrue();
  }
}
