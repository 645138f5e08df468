package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.goal.GoalInformation;

/** Which goal is pursued, when it counts as reached, and what is done without one. */
class PursuedGoalsTest extends PlannedVehicle {
  @Test
  void state_withinThreshold_reportsOnceUntilTheIntervalIsOver() {
    kit.start(PathPlanner::new);
    goals(waypoint("1", 0, 1));
    for (int i = 0; i < 12; i++) {
      kit.publish(Channels.STATE, state(0, 0, 0));
      kit.advance(0.1);
    }

    assertThat(kit.published(Channels.GOAL_REPORTS)).hasSize(2);
    assertThat(kit.published(Channels.GOAL_REPORTS))
        .allMatch(report -> report.completed() && !report.abandoned());
  }

  /** Within its threshold it comes nearer still, so the waypoint is not reported yet. */
  private void driveInto(String uid) {
    kit.with("TURN ACCELERATION", 2.0).start(PathPlanner::new);
    goals(waypoint(uid, 50, 0).horizontalThreshold(10.0));
    for (int north = 0; north <= 45; north++) {
      kit.publish(Channels.STATE, state(north, 0, 0).xDot(10.0).yDot(0.0));
      kit.advance(0.1);
    }
    assertThat(kit.published(Channels.GOAL_REPORTS)).isEmpty();
  }

  @Test
  void goals_movedWhileWithinThreshold_isReachedWhereItIsNow() {
    driveInto("1");
    goals(waypoint("1", 50, 500).horizontalThreshold(10.0));
    kit.publish(Channels.STATE, state(46, 0, 0).xDot(10.0).yDot(0.0));
    kit.advance(0.1);
    assertThat(kit.published(Channels.GOAL_REPORTS)).isEmpty();
    assertThat(logged("missed")).isZero();

    for (int east = 450; east <= 510; east++) {
      kit.publish(Channels.STATE, state(50, east, Math.PI / 2.0).xDot(0.0).yDot(10.0));
      kit.advance(0.1);
    }
    assertThat(kit.published(Channels.GOAL_REPORTS)).isNotEmpty();
    assertThat(kit.published(Channels.GOAL_REPORTS)).allMatch(GoalInformation::completed);
  }

  @Test
  void goals_otherMissionWhoseWaypointHasTheSameName_isReachedWhereItIsNow() {
    driveInto("1");
    goals();
    goals(waypoint("1", 50, 500).horizontalThreshold(10.0));
    kit.publish(Channels.STATE, state(46, 0, 0).xDot(10.0).yDot(0.0));
    assertThat(kit.published(Channels.GOAL_REPORTS)).isEmpty();
  }

  @Test
  void goals_movedJustBeforeASwap_isReachedWhereItIsNow() {
    kit.with("TURN ACCELERATION", 2.0);
    PathPlanner first = kit.start(PathPlanner::new);
    goals(waypoint("1", 50, 0).horizontalThreshold(10.0));
    for (int north = 0; north <= 45; north++) {
      kit.publish(Channels.STATE, state(north, 0, 0).xDot(10.0).yDot(0.0));
      kit.advance(0.1);
    }
    kit.swap(first, PathPlanner::new);
    goals(waypoint("1", 50, 500).horizontalThreshold(10.0));
    kit.publish(Channels.STATE, state(46, 0, 0).xDot(10.0).yDot(0.0));
    assertThat(kit.published(Channels.GOAL_REPORTS)).isEmpty();
  }

  @Test
  void state_fastVehicleCrossesThresholdBetweenTwoStates_isReached() {
    kit.start(PathPlanner::new);
    goals(waypoint("1", 50, 1));
    kit.publish(Channels.STATE, state(0, 0, 0));
    kit.advance(1.0);
    kit.publish(Channels.STATE, state(100, 0, 0));

    assertThat(kit.published(Channels.GOAL_REPORTS)).hasSize(1);
  }

  @Test
  void goals_several_nearestIsPursued() {
    kit.with("LOOK AHEAD", 5.0).start(PathPlanner::new);
    goals(waypoint("far", 100, 0), waypoint("near", -50, 0));
    kit.publish(Channels.STATE, state(0, 0, 0));

    assertThat(point().x()).isCloseTo(-5.0, within(1.0e-9));
    assertThat(logged("goal \"near\" begins")).isEqualTo(1);
  }

  @Test
  void goals_sameSingleGoalAgainAfterItWasReached_mustBeLeftFirst() {
    kit.start(PathPlanner::new);
    goals(waypoint("1", 0, 0));
    kit.publish(Channels.STATE, state(0, 0, 0));
    goals(waypoint("1", 0, 0));
    kit.advance(0.1);
    kit.publish(Channels.STATE, state(0, 0.5, 0));
    assertThat(kit.published(Channels.GOAL_REPORTS)).hasSize(1);

    kit.advance(0.1);
    kit.publish(Channels.STATE, state(0, 9, 0));
    kit.advance(0.1);
    kit.publish(Channels.STATE, state(0, 1, 0));
    assertThat(kit.published(Channels.GOAL_REPORTS)).hasSize(2);
  }

  @Test
  void goals_sameSingleGoalAgain_vehicleThatCanStopReachesItByStaying() {
    kit.start(PathPlanner::new);
    goals(waypoint("1", 0, 0));
    kit.publish(Channels.STATE, state(0, 0, 0));
    goals(waypoint("1", 0, 0));
    for (int i = 0; i < 12; i++) {
      kit.advance(0.1);
      kit.publish(Channels.STATE, state(0, 0, 0));
    }

    assertThat(logged("goal \"1\" reached")).isEqualTo(2);
  }

  @Test
  void goals_sameSingleGoalAgain_aircraftHasToLeaveIt() {
    kit.with("TURN ACCELERATION", 2.0).start(PathPlanner::new);
    goals(waypoint("1", 0, 0));
    kit.publish(Channels.STATE, state(-1, 0, 0).xDot(10.0).yDot(0.0));
    kit.advance(0.1);
    kit.publish(Channels.STATE, state(1, 0, 0).xDot(10.0).yDot(0.0));
    goals(waypoint("1", 0, 0));
    for (int i = 0; i < 12; i++) {
      kit.advance(0.1);
      kit.publish(Channels.STATE, state(1, 0, 0).xDot(10.0).yDot(0.0));
    }

    assertThat(logged("goal \"1\" reached")).isEqualTo(1);
  }

  @Test
  void goals_ofAClassWithoutState_saidOnceAndHeldWhereItIs() {
    kit.with("AT END", "HOLD").start(PathPlanner::new);
    goals(new Dance().uid("waltz"));
    kit.publish(Channels.STATE, state(7, 0, 0));
    kit.advance(0.1);
    kit.publish(Channels.STATE, state(9, 0, 0));

    assertThat(logged("goal \"waltz\" is a [GoalInformation, Dance]: no planner state for that"))
        .isEqualTo(1);
    assertThat(point().x()).isCloseTo(-2.0, within(1.0e-9)); // back to where it was
  }

  @Test
  void goals_newOnesAfterHolding_legBeginsWhereTheVehicleIs() {
    kit.with("LOOK AHEAD", 5.0).with("AT END", "HOLD").start(PathPlanner::new);
    goals(waypoint("1", 0, 0));
    kit.publish(Channels.STATE, state(0, 0, 0));
    goals();
    kit.advance(0.1);
    kit.publish(Channels.STATE, state(50, 0, 0));
    assertThat(point().x()).isCloseTo(-50.0, within(1.0e-9)); // back to the last waypoint

    goals(waypoint("2", 50, 100));
    kit.advance(0.1);
    kit.publish(Channels.STATE, state(50, 0, 0));
    assertThat(point().x()).isCloseTo(0.0, within(1.0e-9));
    assertThat(point().y()).isCloseTo(-5.0, within(1.0e-9));
  }

  @Test
  void goals_emptyAndStopAtEnd_givesNoNavigationPoint() {
    kit.with("AT END", "STOP").start(PathPlanner::new);
    goals();
    kit.publish(Channels.STATE, state(0, 0, 0));

    assertThat(kit.published(Channels.NAVIGATION)).isEmpty();
  }
}
