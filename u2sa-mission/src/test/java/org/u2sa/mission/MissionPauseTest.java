package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.mission.MissionRequest;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.ManualState;

/** A mission that an operator pauses, and how it goes on. */
class MissionPauseTest extends ThreeWaypoints {
  private int orders;

  private static MissionOrder order(MissionAction action) {
    return new MissionOrder().action(action).operator("anna");
  }

  private MissionOrderResult give(MissionOrder order) {
    kit.publish(Channels.MISSION, order.requestId("order " + ++orders));
    return (MissionOrderResult) kit.latest(Channels.MISSION).orElseThrow();
  }

  private void accepted(MissionOrder order, String outcome) {
    MissionOrderResult result = give(order);
    assertThat(result.outcome()).isEqualTo(outcome);
    assertThat(result.accepted()).isTrue();
  }

  private void refused(MissionOrder order, String why) {
    MissionOrderResult result = give(order);
    assertThat(result.outcome()).isEqualTo(why);
    assertThat(result.accepted()).isFalse();
  }

  private void run(String... uids) {
    for (String uid : uids) {
      assertThat(current()).containsExactly(uid);
      complete(uid);
    }
  }

  private MissionReport report() {
    kit.publish(Channels.MISSION, new MissionRequest().requestId("r"));
    return (MissionReport) kit.latest(Channels.MISSION).orElseThrow();
  }

  private void failsafe(FailsafeAction action) {
    kit.publish(Channels.FAILSAFE, new FailsafeState().action(action).causes(List.of("a test")));
  }

  private boolean paused() {
    return kit.latest(Channels.GOALS).orElseThrow().paused();
  }

  @Test
  void goals_tellHowLongTheMissionHasBeenPursued_alsoWhenItsTimeCountsAgain() {
    kit.start(MissionManager::new);
    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(false));
    kit.advance(90.0);
    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(true));
    assertThat(goals().elapsed()).hasValue(0.0);
    assertThat(goals().timestamp()).hasValue(kit.clock().micros());
    kit.advance(8.0);
    complete("1");
    assertThat(goals().elapsed()).hasValue(8.0);
    accepted(order(MissionAction.PAUSE), "paused at 2");
    kit.advance(60.0);
    accepted(order(MissionAction.RESUME), "resumed at [2]");
    assertThat(goals().elapsed()).hasValue(8.0);
  }

  @Test
  void pause_thenResume_goesOnWithTheSameGoal() {
    kit.start(MissionManager::new);
    complete("1");
    assertThat(paused()).isFalse();
    accepted(order(MissionAction.PAUSE), "paused at 2");
    assertThat(current()).containsExactly("2");
    assertThat(paused()).isTrue();
    assertThat(report().paused()).isTrue();
    accepted(order(MissionAction.PAUSE), "already paused at 2");

    accepted(order(MissionAction.RESUME), "resumed at [2]");
    assertThat(paused()).isFalse();
    assertThat(report().paused()).isFalse();
    run("2", "3");
    refused(order(MissionAction.PAUSE), "the mission is over: nothing to pause");
  }

  @Test
  void goTo_pausedMission_endsThePauseAndLeavesAPlaceToGoBackTo() {
    kit.start(MissionManager::new);
    accepted(order(MissionAction.PAUSE), "paused at 1");
    accepted(order(MissionAction.GOTO).uid("3"), "pursuing goal \"3\"");
    assertThat(paused()).isFalse();

    accepted(order(MissionAction.PAUSE), "paused at 3");
    accepted(order(MissionAction.RESUME), "resumed at [3]");
    accepted(order(MissionAction.RESUME), "resumed at [1]");
  }

  @Test
  void skipAndUpdate_pausedMission_leaveItPausedUntilNothingIsLeft() {
    kit.start(MissionManager::new);
    accepted(order(MissionAction.PAUSE), "paused at 1");
    accepted(order(MissionAction.SKIP), "goal \"1\" skipped; current: 2");
    assertThat(paused()).isTrue();
    accepted(order(MissionAction.SKIP), "goal \"2\" skipped; current: 3");
    accepted(order(MissionAction.SKIP), "goal \"3\" skipped; current: none, the mission is over");
    assertThat(paused()).isFalse();
    refused(order(MissionAction.RESUME), "nothing to resume: the mission was not interrupted");
  }

  @Test
  void pause_failsafeComes_itsGoalsArePursuedAndTheMissionStaysPaused() throws IOException {
    Path home = directory.resolve("return.xml");
    Files.writeString(home, "<mission><waypoint><x>9</x></waypoint></mission>");
    kit.with("RETURN MISSION", home.toString());
    kit.start(MissionManager::new);
    accepted(order(MissionAction.PAUSE), "paused at 1");
    failsafe(FailsafeAction.RETURN);
    assertThat(paused()).isFalse();
    assertThat(current()).isNotEmpty().doesNotContain("1");
    accepted(
        order(MissionAction.PAUSE), "already paused at 1; the failsafe RETURN is pursued first");
    failsafe(FailsafeAction.CONTINUE);
    assertThat(current()).containsExactly("1");
    assertThat(paused()).isTrue();
  }

  @Test
  void goToAndInsertNow_duringAFailsafe_leaveTheMissionPaused() throws IOException {
    Path home = directory.resolve("return.xml");
    Files.writeString(
        home,
        "<mission><waypoint><name>a</name><x>9</x></waypoint>"
            + "<waypoint><name>b</name><x>8</x></waypoint></mission>");
    kit.with("RETURN MISSION", home.toString());
    kit.start(MissionManager::new);
    accepted(order(MissionAction.PAUSE), "paused at 1");
    failsafe(FailsafeAction.RETURN);
    accepted(order(MissionAction.GOTO).uid("RETURN b"), "pursuing goal \"RETURN b\"");
    accepted(
        order(MissionAction.INSERT)
            .goals("<mission><waypoint><name>new</name><x>4</x></waypoint></mission>")
            .now(true),
        "pursuing \"new\", then 1; the failsafe RETURN is pursued first");
    assertThat(current()).containsExactly("RETURN b");
    failsafe(FailsafeAction.CONTINUE);

    assertThat(current()).containsExactly("new");
    assertThat(paused()).isTrue();
  }

  @Test
  void pause_managerIsReplaced_staysPaused() {
    MissionManager before = kit.start(MissionManager::new);
    accepted(order(MissionAction.PAUSE), "paused at 1");
    kit.swap(before, MissionManager::new);
    assertThat(paused()).isTrue();
  }

  @Test
  void pause_timeLimits_standMeanwhile() throws IOException {
    Files.writeString(
        file,
        "<mission><timeLimit>30</timeLimit><waypoint><x>1</x><timeLimit>10</timeLimit></waypoint>"
            + "<waypoint><x>2</x></waypoint></mission>");
    kit.start(MissionManager::new);
    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(true));
    kit.advance(8.0);
    accepted(order(MissionAction.PAUSE), "paused at 1");
    kit.advance(60.0);
    assertThat(current()).containsExactly("1");
    assertThat(report().elapsed()).isEqualTo(8.0);

    accepted(order(MissionAction.RESUME), "resumed at [1]");
    kit.advance(1.8);
    assertThat(current()).containsExactly("1");
    kit.advance(0.4);
    assertThat(current()).containsExactly("2");
    assertThat(report().elapsed()).isEqualTo(10.2);
  }

  @Test
  void insertNow_pausedMission_endsThePause_insertAfterDoesNot() {
    kit.start(MissionManager::new);
    accepted(order(MissionAction.PAUSE), "paused at 1");
    String goal = "<mission><waypoint><name>%s</name><x>4</x></waypoint></mission>";
    accepted(
        order(MissionAction.INSERT).goals(String.format(goal, "later")).uid("2"),
        "inserted \"later\" after \"2\"");
    assertThat(paused()).isTrue();
    accepted(
        order(MissionAction.INSERT).goals(String.format(goal, "at once")).now(true),
        "pursuing \"at once\", then 1");
    assertThat(paused()).isFalse();
  }

  @Test
  void goalCommand_pausedMission_endsThePause() {
    kit.start(MissionManager::new);
    accepted(order(MissionAction.PAUSE), "paused at 1");
    kit.publish(Channels.GOAL_COMMANDS, new GoalCommand().uid("2"));
    assertThat(current()).containsExactly("2");
    assertThat(paused()).isFalse();
  }

  private void drive(boolean active) {
    ManualState state = new ManualState().active(active).operator("Ann");
    state.timestamp(kit.clock().micros());
    kit.publish(Channels.MANUAL_STATE, state);
  }

  /** They would take effect when the driver hands the vehicle back. */
  @ParameterizedTest
  @EnumSource(names = {"GOTO", "RESUME", "RETURN", "LAND"})
  void obey_whileDrivenByHand_isRefusedAndTheMissionStaysPaused(MissionAction action) {
    kit.start(MissionManager::new);
    drive(true);
    assertThat(paused()).isTrue();

    refused(
        order(action).uid("2"),
        "the vehicle is driven by hand by \"Ann\"; expected the order afterwards");
    kit.publish(Channels.GOAL_COMMANDS, new GoalCommand().uid("2"));
    assertThat(paused()).isTrue();
    assertThat(current()).containsExactly("1");
    accepted(order(MissionAction.SKIP), "goal \"1\" skipped; current: 2");
    drive(false);
    accepted(order(MissionAction.GOTO).uid("3"), "pursuing goal \"3\"");
  }

  private ManualState driven(boolean active, long takeovers, double secondsAgo) {
    ManualState state = new ManualState().active(active).operator("Ann").takeovers(takeovers);
    state.timestamp(kit.clock().micros() - Clock.micros(secondsAgo));
    return state;
  }

  @Test
  void restart_whileDrivenByHand_staysPausedAndRefusesOrdersUntilTheEnd() {
    MissionManager before = kit.start(MissionManager::new);
    kit.publish(Channels.MANUAL_STATE, driven(true, 1, 0.0));
    kit.advance(30.0);
    kit.restart(before, MissionManager::new);
    kit.publish(Channels.MANUAL_STATE, driven(true, 1, 30.0)); // retained

    assertThat(paused()).isTrue();
    refused(
        order(MissionAction.RESUME),
        "the vehicle is driven by hand by \"Ann\"; expected the order afterwards");
    kit.publish(Channels.MANUAL_STATE, driven(false, 1, 0.0));
    assertThat(paused()).isTrue();
    accepted(order(MissionAction.RESUME), "resumed at [1]");
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void restart_driveBegunInItsAbsence_pausesAlsoIfItHasEnded(boolean active) {
    MissionManager before = kit.start(MissionManager::new);
    before.kill();
    kit.advance(30.0);
    kit.restart(before, MissionManager::new);
    assertThat(paused()).isFalse();
    kit.publish(Channels.MANUAL_STATE, driven(active, 1, 20.0)); // retained

    assertThat(paused()).isTrue();
  }

  @Test
  void restart_driveThatTheOperatorHasLeftBehind_goesOn() {
    MissionManager before = kit.start(MissionManager::new);
    kit.publish(Channels.MANUAL_STATE, driven(true, 1, 0.0));
    kit.publish(Channels.MANUAL_STATE, driven(false, 1, 0.0));
    accepted(order(MissionAction.RESUME), "resumed at [1]");
    kit.restart(before, MissionManager::new);
    kit.publish(Channels.MANUAL_STATE, driven(false, 1, 20.0)); // retained

    assertThat(paused()).isFalse();
  }

  @Test
  void start_retainedStateOfAnotherRun_doesNotPause() {
    kit.start(MissionManager::new);
    kit.publish(Channels.MANUAL_STATE, driven(true, 3, 20.0));
    kit.publish(Channels.MANUAL_STATE, driven(false, 3, 20.0));

    assertThat(paused()).isFalse();
  }
}
