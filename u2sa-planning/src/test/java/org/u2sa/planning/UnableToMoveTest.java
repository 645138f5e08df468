package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.ObjectGoal;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;

/** A vehicle that may not move, or whose state is unknown, keeps its goals. */
class UnableToMoveTest extends PlannedVehicle {
  /** What keeps the vehicle from moving. */
  private enum Hindrance {
    DISARMED,
    STOPPED,
    NO_STATE
  }

  private void start(GoalInformation goal) {
    kit.with("PLANNER", "GRID").with("STATION GIVE UP AFTER", 20.0).start(PathPlanner::new);
    goals(goal);
    stands(0.5, true);
  }

  private void stands(double seconds, boolean hasStates) {
    for (double t = 0.0; t < seconds; t += 0.5) {
      kit.advance(0.5);
      kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of()));
      if (hasStates) {
        kit.publish(Channels.STATE, state(0, 0, 0).xDot(0.0).yDot(0.0));
      }
    }
  }

  private void hinder(Hindrance hindrance, double seconds) {
    switch (hindrance) {
      case DISARMED -> {
        kit.publish(Channels.ARMING_STATE, new ArmingState().armed(false));
        stands(seconds, true);
        kit.publish(Channels.ARMING_STATE, new ArmingState().armed(true));
      }
      case STOPPED -> {
        fail(FailsafeAction.STOP);
        stands(seconds, true);
        fail(FailsafeAction.CONTINUE);
      }
      case NO_STATE -> stands(seconds, false);
    }
  }

  private void fail(FailsafeAction action) {
    kit.publish(Channels.FAILSAFE, new FailsafeState().action(action).causes(List.of()));
  }

  private List<GoalInformation> reports() {
    return kit.published(Channels.GOAL_REPORTS);
  }

  private static Station station() {
    Station station = new Station();
    station.duration(5.0).uid("1").referenceFrame(ReferenceFrame.LOCAL_NED).x(1.5).y(0.0);
    station.horizontalThreshold(0.5);
    return station;
  }

  private static ObjectGoal object() {
    ObjectGoal object = new ObjectGoal();
    object.objectType("Buoy").within(1.0).uid("1");
    return object;
  }

  @ParameterizedTest
  @EnumSource(Hindrance.class)
  void waypoint_longUnableToMove_isPursuedAfterwards(Hindrance hindrance) {
    start(waypoint("1", 20, 0));

    hinder(hindrance, 300.0);
    stands(3.0, true);

    assertThat(reports()).isEmpty();
    assertThat(logged("stuck")).isZero();
  }

  @ParameterizedTest
  @EnumSource(Hindrance.class)
  void station_longUnableToMove_isPursuedAfterwards(Hindrance hindrance) {
    start(station());

    hinder(hindrance, 300.0);
    stands(3.0, true);

    assertThat(reports()).isEmpty();
  }

  @ParameterizedTest
  @EnumSource(value = Hindrance.class, mode = EnumSource.Mode.EXCLUDE, names = "NO_STATE")
  void objectGoal_longUnableToMove_isPursuedAfterwards(Hindrance hindrance) {
    start(object());

    hinder(hindrance, 300.0);
    stands(3.0, true);

    assertThat(reports()).isEmpty();
  }

  @Test
  void waypoint_armedButStuck_isGivenUp() {
    start(waypoint("1", 20, 0));

    hinder(Hindrance.DISARMED, 300.0);
    stands(120.0, true);

    assertThat(reports()).isNotEmpty();
    assertThat(reports().get(0).abandoned()).isTrue();
  }
}
