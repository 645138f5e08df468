package org.u2sa.scenarios.roboboat.subvehicle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.planning.Plan;
import org.u2sa.planning.Pursuit;

/** The sub-vehicle's states one by one, on a local plane; the object is 3 m north of the deck. */
class FetchStateTest {
  private boolean isHolding = true;
  private final FetchState fetch = new FetchState(() -> isHolding);
  private final FetchGoal goal = goal();

  private static FetchGoal goal() {
    FetchGoal goal = new FetchGoal().gripTime(2.0).limit(60.0);
    goal.referenceFrame(ReferenceFrame.LOCAL_ENU).x(0.0).y(3.0).z(0.5);
    goal.horizontalThreshold(0.2).verticalThreshold(0.1).uid("puck");
    return goal;
  }

  private Pursuit at(double timeS, double north, double up) {
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_ENU)
            .x(0.0)
            .y(north)
            .z(up)
            .psi(0.0);
    state.timestamp((long) (timeS * 1e6));
    return new Pursuit(goal, Optional.empty(), Optional.empty(), state);
  }

  private Plan plan(double timeS, double north, double up) {
    return fetch.plan(at(timeS, north, up));
  }

  private static Point target(Plan plan) {
    NavigationPoint point = plan.points().get(0);
    return point.point(); // BODY, heading east: forward is east
  }

  private void descend() {
    fetch.enter(at(0.0, 0.0, 0.2));
    plan(1.0, 0.0, 2.5);
    plan(5.0, 3.0, 2.5);
  }

  @Test
  void plan_fromTheDeck_climbsStraightUpFirst() {
    fetch.enter(at(0.0, 0.0, 0.2));
    Point target = target(plan(0.1, 0.0, 0.2));

    assertThat(target.x()).isEqualTo(0.0);
    assertThat(Math.abs(target.z())).isEqualTo(2.3); // 2 m above the object, the higher of both
  }

  @Test
  void plan_aboveTheObjectForTheGripTime_returnsAndCompletesOnTheDeck() {
    descend();
    assertThat(plan(8.0, 3.0, 0.5).progress()).isEqualTo(Plan.Progress.UNDER_WAY);
    assertThat(plan(9.0, 3.0, 0.5).remark()).isEmpty();
    Plan gripped = plan(10.0, 3.0, 0.5);
    plan(13.0, 3.0, 2.5);
    plan(16.0, 0.0, 2.5);
    plan(19.0, 0.0, 0.2);
    Plan back = plan(22.0, 0.0, 0.2);

    assertThat(gripped.remark()).startsWith("gripped");
    assertThat(gripped.changed().orElseThrow().arrivedAt()).hasValue(8_000_000L);
    assertThat(back.progress()).isEqualTo(Plan.Progress.COMPLETED);
  }

  @Test
  void plan_deckMovedMeanwhile_landsWhereItIs() {
    descend();
    plan(8.0, 3.0, 0.5);
    plan(10.0, 3.0, 0.5);
    goal.deckNorth(-0.8).deckEast(0.3);
    Point back = target(plan(13.0, 3.0, 2.5));
    Plan notYet = plan(16.0, 0.0, 2.5);

    assertThat(back.x()).isCloseTo(0.3, within(1e-6));
    assertThat(Math.abs(back.y())).isCloseTo(3.8, within(1e-6));
    assertThat(Math.abs(target(notYet).y())).isCloseTo(0.8, within(1e-6));
  }

  @Test
  void plan_blownOffWhileGripping_startsTheGripTimeAnew() {
    descend();
    plan(8.0, 3.0, 0.5);
    plan(9.0, 3.3, 0.5); // beyond the threshold, but not twice
    plan(9.5, 3.0, 0.5);

    assertThat(plan(11.0, 3.0, 0.5).remark()).isEmpty();
    assertThat(plan(11.5, 3.0, 0.5).remark()).startsWith("gripped");
  }

  @Test
  void plan_blownFarOffWhileDescending_climbsAndTriesAgain() {
    descend();
    Plan off = plan(7.0, 3.5, 1.0);

    assertThat(off.remark()).contains("drifted from above the object");
    assertThat(Math.abs(target(off).z())).isEqualTo(1.5); // back to the flight's altitude
  }

  @Test
  void plan_outOfTime_landsWithoutTheObjectAndSaysSo() {
    descend();
    plan(60.5, 3.0, 0.9);
    plan(63.0, 3.0, 2.5);
    plan(66.0, 0.0, 2.5);
    plan(69.0, 0.0, 0.2);
    Plan back = plan(72.0, 0.0, 0.2);

    assertThat(back.progress()).isEqualTo(Plan.Progress.ABANDONED);
    assertThat(back.remark()).isEqualTo("given up: back without the object, out of time");
  }

  @Test
  void plan_gripperHoldsNothing_triesAgainBesideTheExpectedPlace() {
    isHolding = false;
    descend();
    plan(8.0, 3.0, 0.5);
    Plan waits = plan(10.5, 3.0, 0.5);
    Plan again = plan(11.6, 3.0, 0.5);
    plan(14.0, 3.3, 2.5);
    isHolding = true;
    plan(17.0, 3.3, 0.5);
    Plan gripped = plan(19.0, 3.3, 0.5);

    assertThat(waits.remark()).isEmpty();
    assertThat(again.remark()).isEqualTo("the gripper holds nothing: attempt 2");
    assertThat(Math.hypot(target(again).x(), target(again).y())).isCloseTo(0.3, within(1e-9));
    assertThat(gripped.remark()).startsWith("gripped");
  }

  @Test
  void plan_objectLostOnTheWayBack_saysThatItIsNotBack() {
    descend();
    plan(8.0, 3.0, 0.5);
    plan(10.0, 3.0, 0.5);
    plan(13.0, 3.0, 2.5);
    isHolding = false;
    plan(16.0, 0.0, 2.5);
    plan(19.0, 0.0, 0.2);
    Plan back = plan(22.0, 0.0, 0.2);

    assertThat(back.progress()).isEqualTo(Plan.Progress.ABANDONED);
    assertThat(back.remark()).isEqualTo("given up: back without the object, lost on the way");
  }

  @Test
  void plan_gripperHoldsNothingUntilTheLimit_saysHowOften() {
    isHolding = false;
    descend();
    plan(8.0, 3.0, 0.5);
    plan(11.6, 3.0, 0.5);
    plan(61.0, 3.3, 0.5);
    plan(63.0, 3.0, 2.5);
    plan(66.0, 0.0, 2.5);
    plan(69.0, 0.0, 0.2);
    Plan back = plan(72.0, 0.0, 0.2);

    assertThat(back.remark())
        .isEqualTo("given up: back without the object, the gripper held nothing once");
  }
}
