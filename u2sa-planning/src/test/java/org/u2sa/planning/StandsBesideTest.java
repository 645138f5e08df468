package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.safety.ArmingState;

/** A vehicle that can stop and stands beside a goal that it cannot reach. */
class StandsBesideTest extends PlannedVehicle {
  @BeforeEach
  void start() {
    kit.start(PathPlanner::new);
  }

  private void stands(double north, double down, double seconds) {
    for (double t = 0.0; t < seconds; t += 0.5) {
      kit.advance(0.5);
      kit.publish(Channels.STATE, state(north, 0, 0).z(down).xDot(0.0).yDot(0.0));
    }
  }

  private List<GoalInformation> reports() {
    return kit.published(Channels.GOAL_REPORTS);
  }

  private void requireGivenUp(String why) {
    assertThat(reports()).isNotEmpty();
    assertThat(reports().get(0).abandoned()).isTrue();
    assertThat(reports().get(0).reason().orElseThrow()).contains(why);
  }

  @Test
  void waypoint_tooHighForAGroundVehicle_isGivenUpWithTheReason() {
    goals(waypoint("1", 10, 0).z(-3.0).verticalThreshold(0.5));
    stands(9.85, 0.0, 25.0);

    requireGivenUp("0.15 m beside it and 3.0 m off its altitude");
  }

  @Test
  void waypoint_thresholdBelowTheControlsReach_isGivenUpWithTheReason() {
    goals(waypoint("1", 10, 0).horizontalThreshold(0.05));
    stands(9.85, 0.0, 25.0);

    requireGivenUp("0.15 m beside it and 0.0 m off its altitude");
  }

  @Test
  void waypoint_vehicleClimbsSlowly_isNotGivenUp() {
    goals(waypoint("1", 10, 0).z(-30.0).verticalThreshold(0.5));
    for (double down = 0.0; down > -28.0; down -= 0.2) {
      stands(9.85, down, 1.0);
    }

    assertThat(reports()).isEmpty();
  }

  @Test
  void waypoint_vehicleIsDisarmed_isNotGivenUp() {
    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(false));
    goals(waypoint("1", 10, 0).horizontalThreshold(0.05));
    stands(9.85, 0.0, 60.0);
    assertThat(reports()).isEmpty();

    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(true));
    stands(9.85, 0.0, 15.0);
    assertThat(reports()).as("it had no time yet").isEmpty();
    stands(9.85, 0.0, 10.0);
    requireGivenUp("0.15 m beside it");
  }

  @Test
  void waypoint_stuckFarAway_isNotGivenUp() {
    goals(waypoint("1", 10, 0).horizontalThreshold(0.5));
    stands(5.0, 0.0, 60.0);

    assertThat(reports()).isEmpty();
  }

  @Test
  void takeOff_armedVehicleThatStands_isRemarkedOnce() {
    TakeOff takeOff = new TakeOff();
    takeOff.uid("up").referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0).z(-10.0);
    takeOff.horizontalThreshold(2.0);
    goals(takeOff);
    stands(0.0, 0.0, 50.0);
    assertThat(logged("on the ground for a minute")).isZero();
    stands(0.0, 0.0, 50.0);

    assertThat(logged("on the ground for a minute")).isEqualTo(1);
    assertThat(reports()).as("its engine may still start").isEmpty();
  }
}
