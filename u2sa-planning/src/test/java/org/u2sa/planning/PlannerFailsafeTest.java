package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.testkit.ServiceKit;

/** What the planner does when a failsafe says so. */
@Timeout(120)
class PlannerFailsafeTest {
  private final ServiceKit kit = new ServiceKit();
  private final GoalList goals = new GoalList();
  private PathPlanner planner;

  @AfterEach
  void close() {
    kit.close();
  }

  private void begin() {
    begin(5.0);
  }

  private void begin(double speedMps) {
    planner = kit.start(PathPlanner::new);
    Waypoint far =
        new Waypoint()
            .uid("1")
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(1000.0)
            .y(0.0)
            .horizontalThreshold(2.0);
    goals.goals(List.of(far));
    kit.publish(Channels.GOALS, (GoalList) goals.copy());
    state(0.0, speedMps);
  }

  private void state(double north) {
    state(north, 5.0);
  }

  private void state(double north, double speedMps) {
    state(north, speedMps, 80.0);
  }

  private void state(double north, double speedMps, double upM) {
    kit.advance(0.1);
    kit.publish(
        Channels.STATE,
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(north)
            .y(0.0)
            .z(-upM)
            .psi(0.0)
            .xDot(speedMps)
            .yDot(0.0));
  }

  private void failsafe(FailsafeAction action) {
    kit.publish(Channels.FAILSAFE, new FailsafeState().action(action).causes(List.of("a test")));
  }

  private double aheadM() {
    return kit.latest(Channels.NAVIGATION).orElseThrow().point().x();
  }

  /** Without a Mission Manager nobody answers it with other goals. */
  @ParameterizedTest
  @EnumSource(names = {"RETURN", "LAND"})
  void failsafe_thatNobodyAnswers_holdsInsteadOfLeadingAlongTheMission(FailsafeAction action) {
    kit.with("LOOK AHEAD", 10.0);
    begin(1.0);
    failsafe(FailsafeAction.CONTINUE);
    kit.advance(5.0);
    state(50.0, 1.0);
    assertThat(aheadM()).isGreaterThan(5.0);

    failsafe(action);
    kit.forget();
    state(50.0, 0.0);
    state(50.0, 0.0);
    assertThat(kit.published(Channels.NAVIGATION))
        .as("holds")
        .allMatch(point -> Math.abs(point.point().x()) < 1.0);
    kit.advance(10.0);
    failsafe(action); // repeated
    kit.publish(Channels.GOALS, ((GoalList) goals.copy()).returning(true));
    state(50.0, 0.0);
    assertThat(aheadM()).as("the way back").isGreaterThan(5.0);
  }

  /** Points of before the end of the drive would lead a Control that restarts away. */
  @Test
  void pause_drivenByHand_leadsNowhereAlready() {
    kit.with("LOOK AHEAD", 10.0).with("AT END", "HOLD");
    begin(1.0);
    kit.publish(Channels.GOALS, ((GoalList) goals.copy()).paused(true));
    state(20.0, 1.0);
    kit.publish(Channels.MANUAL_STATE, new ManualState().active(true).operator("Ann").takeovers(1));
    state(30.0, 1.0);
    state(40.0, 1.0);
    assertThat(aheadM()).isCloseTo(0.0, within(1e-6));
  }

  @Test
  void failsafe_keptFromAnEarlierRun_isIgnoredUntilOneIsHeardInThisRun() {
    kit.with("LOITER RADIUS", 50.0).with("LOOK AHEAD", 10.0);
    failsafe(FailsafeAction.HOLD);
    kit.advance(6.0);
    begin();
    state(100.0);
    state(150.0);
    assertThat(point().y()).isCloseTo(0.0, within(1e-9));
    assertThat(kit.log("PathPlanner"))
        .anyMatch(line -> line.contains("ignored failsafe HOLD: sent 6 s ago, by an earlier run"));

    failsafe(FailsafeAction.HOLD);
    state(200.0);
    state(250.0);

    assertThat(point().y()).isCloseTo(-50.0 * Math.sin(10.0 / 50.0), within(1e-6));
  }

  @Test
  void goals_leadHomeWhileAnAeroplaneStands_itStaysAndSaysSoOnce() {
    kit.with("LOITER RADIUS", 50.0).with("TURN ACCELERATION", 3.0);
    goals.returning(true);
    begin(0.0);
    stands();
    assertThat(kit.published(Channels.NAVIGATION)).isEmpty();
    assertThat(kit.log("PathPlanner"))
        .filteredOn(line -> line.contains("returning: already on the ground"))
        .hasSize(1);

    kit.publish(Channels.GOALS, (GoalList) goals.returning(false).copy());
    stands();
    assertThat(kit.published(Channels.NAVIGATION)).hasSize(1);
  }

  private void stands() {
    state(0.0, 0.0);
  }

  @Test
  void failsafe_aeroplaneWhosePlannerRestartedInTheClimb_stillHoldsAtMinHoldHeight() {
    kit.with("LOITER RADIUS", 50.0).with("TURN ACCELERATION", 3.0).with("LOOK AHEAD", 10.0);
    begin(0.0);
    state(20.0, 20.0, 80.5); // 0.5 m up
    kit.advance(2.0);
    planner = kit.restart(planner, PathPlanner::new);
    failsafe(FailsafeAction.HOLD);
    state(100.0, 20.0, 95.0);

    assertThat(point().z()).isCloseTo(-25.0, within(1e-9)); // to 80 m + MIN HOLD HEIGHT
  }

  @Test
  void failsafe_keptWhileThePlannerRestarts_counts() {
    kit.with("LOITER RADIUS", 50.0).with("LOOK AHEAD", 10.0);
    begin();
    failsafe(FailsafeAction.HOLD);
    kit.advance(6.0);

    kit.restart(planner, PathPlanner::new);
    state(100.0);
    state(150.0);

    assertThat(point().y()).isCloseTo(-50.0 * Math.sin(10.0 / 50.0), within(1e-6));
  }

  private static GoalList pausing(GoalList goals, boolean pauses) {
    return ((GoalList) goals.copy()).paused(pauses);
  }

  private Point point() {
    return kit.latest(Channels.NAVIGATION).orElseThrow().point();
  }

  @Test
  void hold_aircraft_circlesWhereItWasAndThenGoesOn() {
    kit.with("AT END", "HOLD").with("LOITER RADIUS", 50.0).with("LOOK AHEAD", 10.0);
    begin();
    assertThat(point().x()).isCloseTo(10.0, within(1e-9));
    failsafe(FailsafeAction.HOLD);
    state(100.0);
    state(150.0); // on the circle round the place of the first state after the order

    assertThat(point().y()).isCloseTo(-50.0 * Math.sin(10.0 / 50.0), within(1e-6));
    failsafe(FailsafeAction.CONTINUE);
    state(160.0);
    assertThat(point().y()).isCloseTo(0.0, within(1e-9));
  }

  @Test
  void pausedMission_aircraft_circlesWhereItWasAndThenPursuesTheSameGoal() {
    kit.with("AT END", "STOP").with("LOITER RADIUS", 50.0).with("LOOK AHEAD", 10.0);
    begin();
    kit.publish(Channels.GOALS, pausing(goals, true));
    state(100.0);
    state(150.0);
    assertThat(point().y()).isCloseTo(-50.0 * Math.sin(10.0 / 50.0), within(1e-6));

    failsafe(FailsafeAction.HOLD);
    failsafe(FailsafeAction.CONTINUE);
    state(155.0); // still paused
    assertThat(point().y()).isNotCloseTo(0.0, within(0.1));

    kit.publish(Channels.GOALS, pausing(goals, false));
    state(160.0);
    assertThat(point().y()).isCloseTo(0.0, within(1e-9));
  }

  @Test
  void pausedMission_vehicleThatCanStand_getsNoPoints() {
    kit.with("AT END", "STOP").with("LOITER RADIUS", 0.0).with("LOOK AHEAD", 10.0);
    begin();
    int before = kit.published(Channels.NAVIGATION).size();
    kit.publish(Channels.GOALS, pausing(goals, true));
    state(1.0);
    assertThat(kit.published(Channels.NAVIGATION)).hasSize(before);

    kit.publish(Channels.GOALS, pausing(goals, false));
    state(1.0);
    assertThat(kit.published(Channels.NAVIGATION)).hasSize(before + 1);
  }

  @Test
  void hold_aircraftThatGetsNoPointsAtTheMissionsEnd_circlesAllTheSame() {
    kit.with("AT END", "STOP").with("LOITER RADIUS", 50.0).with("LOOK AHEAD", 10.0);
    begin();
    failsafe(FailsafeAction.HOLD);
    state(100.0);
    state(150.0);

    assertThat(point().y()).isCloseTo(-50.0 * Math.sin(10.0 / 50.0), within(1e-6));
  }

  @Test
  void return_aircraftThatIsHome_circlesWhateverTheMissionsEndSays() {
    kit.with("AT END", "STOP").with("LOITER RADIUS", 50.0).with("LOOK AHEAD", 10.0);
    begin();
    failsafe(FailsafeAction.RETURN);
    kit.publish(Channels.GOALS, new GoalList()); // home is reached
    kit.forget();
    state(100.0);

    assertThat(kit.published(Channels.NAVIGATION)).hasSize(1);
  }

  @Test
  void hold_vehicleThatStopsAtTheEnd_givesNoNavigationPoints() {
    begin();
    failsafe(FailsafeAction.HOLD);
    kit.forget();
    state(10.0);

    assertThat(kit.published(Channels.NAVIGATION)).isEmpty();
  }

  @Test
  void stop_givesNoNavigationPoints() {
    kit.with("AT END", "HOLD");
    begin();
    failsafe(FailsafeAction.STOP);
    kit.forget();
    state(10.0);

    assertThat(kit.published(Channels.NAVIGATION)).isEmpty();
  }
}
