package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.ObjectGoal;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.shape.Circle;

/** States stop while a barrel is seen from the vehicle, 3 m ahead and 2 m to the left. */
class PlannerWithoutStateTest extends PlannedVehicle {
  private PathPlanner planner;

  @BeforeEach
  void start() {
    planner = kit.with("AT END", "HOLD").start(PathPlanner::new);
  }

  private static Circle barrel(ReferenceFrame frame, double x, double y) {
    return new Circle()
        .radius(0.3)
        .uid(frame + " barrel")
        .objectType("barrel")
        .referenceFrame(frame)
        .x(x)
        .y(y);
  }

  private static ObjectGoal toBarrel() {
    return new ObjectGoal().uid("barrel").objectType("barrel").within(1.0);
  }

  private void drive() {
    for (int i = 0; i < 5; i++) {
      kit.advance(0.1);
      kit.publish(Channels.STATE, state(i, 0, 0));
    }
  }

  /** Navigation points after the last state is too old. */
  private int pointsAtSight(ObjectDescription... seen) {
    kit.advance(4.0);
    kit.forget();
    for (int i = 0; i < 15; i++) {
      ObjectList list = new ObjectList().objects(List.of(seen));
      list.timestamp(kit.clock().micros());
      kit.publish(Channels.OBJECTS, list);
      kit.advance(0.1);
    }
    return kit.published(Channels.NAVIGATION).size();
  }

  private int pointsAtSight() {
    return pointsAtSight(barrel(ReferenceFrame.BODY, 3.0, 2.0));
  }

  @Test
  void objects_waypoint_givesNoPoints() {
    goals(waypoint("1", 50, 0));
    drive();
    assertThat(pointsAtSight()).isZero();
  }

  @Test
  void objects_missionOver_givesNoPoints() {
    goals(waypoint("1", 50, 0));
    drive();
    goals();
    drive();
    assertThat(pointsAtSight()).isZero();
  }

  @Test
  void objects_paused_givesNoPoints() {
    pause(toBarrel());
    drive();
    assertThat(pointsAtSight()).isZero();
  }

  private void pause(GoalInformation goal) {
    kit.publish(
        Channels.GOALS, new GoalList().goals(List.of(goal)).upcoming(List.of()).paused(true));
  }

  @ParameterizedTest
  @EnumSource(names = "CONTINUE", mode = EnumSource.Mode.EXCLUDE)
  void objects_failsafe_givesNoPoints(FailsafeAction action) {
    goals(toBarrel());
    drive();
    kit.publish(Channels.FAILSAFE, new FailsafeState().action(action).causes(List.of("position")));
    assertThat(pointsAtSight()).isZero();
  }

  @Test
  void objects_goalIsWhatIsSeen_isApproached() {
    goals(toBarrel());
    drive();
    assertThat(pointsAtSight()).isEqualTo(15);
    assertThat(point().x()).isPositive();
    assertThat(point().y()).isPositive();
  }

  @Test
  void objects_listsWithoutItForLong_goalIsAbandoned() {
    goals(toBarrel());
    boolean isAbandoned = false;
    for (int i = 0; i < 30 && !isAbandoned; i++) { // each forgets what was published before
      pointsAtSight(new ObjectDescription[0]);
      isAbandoned =
          kit.published(Channels.GOAL_REPORTS).stream().anyMatch(GoalInformation::abandoned);
    }
    assertThat(isAbandoned).isTrue();
  }

  @Test
  void objects_waypointOrWhatIsSeen_waypointBegunIsKept() {
    goals(waypoint("near", 20, 0), toBarrel());
    drive();
    assertThat(pointsAtSight()).isZero();
  }

  @Test
  void objects_waypointOnTheEarthOrWhatIsSeen_approachesWhatIsSeen() {
    goals(new Waypoint().uid("1").x(10.0).y(50.0).horizontalThreshold(1.0), toBarrel());
    assertThat(pointsAtSight()).isEqualTo(15);
  }

  @Test
  void objects_nearerOneIsOnTheMapOnly_isNotApproachedFromAnInventedPlace() {
    goals(toBarrel());
    pointsAtSight(
        barrel(ReferenceFrame.LOCAL_NED, -1.5, 0.0), barrel(ReferenceFrame.BODY, 3.0, 2.0));
    assertThat(point().x()).isPositive();
    assertThat(point().y()).isPositive();
  }

  @Test
  void objects_heldOnTheEarth_plannerDoesNotFail() {
    pause(new Waypoint().uid("1").x(10.0).y(50.001).horizontalThreshold(1.0));
    for (int i = 0; i < 5; i++) {
      kit.publish(Channels.STATE, new StateInformation().x(10.0).y(50.0).psi(0.0));
      kit.advance(0.1);
    }
    assertThat(pointsAtSight()).isZero();
    assertThat(planner.status()).isEqualTo(ServiceStatus.RUNNING);
  }

  @Test
  void states_heldOnTheEarthThenLocal_givesNoPointsAndDoesNotFail() {
    pause(new Waypoint().uid("1").x(10.0).y(50.001).horizontalThreshold(1.0));
    kit.publish(Channels.STATE, new StateInformation().x(10.0).y(50.0).psi(0.0));
    kit.forget();
    for (int i = 0; i < 15; i++) {
      kit.advance(0.1);
      kit.publish(Channels.STATE, state(0, 0, 0));
    }
    assertThat(planner.status()).isEqualTo(ServiceStatus.RUNNING);
    assertThat(kit.published(Channels.NAVIGATION)).isEmpty();
  }
}
