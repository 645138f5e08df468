package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.safety.FenceState;

/** What operators order of a running mission, and what they are answered. */
class MissionOrdersTest extends OrderedMission {

  @Test
  void goTo_thenResume_goesBackToWhereItWas() {
    kit.start(MissionManager::new);
    complete("1");
    accepted(order(MissionAction.GOTO).uid("3"), "pursuing goal \"3\"");
    assertThat(current()).containsExactly("3");
    assertThat(report().resumable()).contains("2");

    accepted(order(MissionAction.RESUME), "resumed at [2]");
    run("2", "3");
    assertThat(current()).isEmpty();
  }

  @Test
  void goTo_thatGoalIsDone_resumeStillGoesBack() {
    kit.start(MissionManager::new);
    accepted(order(MissionAction.GOTO).uid("2"), "pursuing goal \"2\"");
    run("2");
    accepted(order(MissionAction.RESUME), "resumed at [1]");
  }

  @Test
  void goTo_interruptedGoalItselfIsDone_resumeGoesBackToWhatCameAfterIt() {
    kit.start(MissionManager::new);
    accepted(order(MissionAction.GOTO).uid("1"), "pursuing goal \"1\"");
    complete("1");
    assertThat(report().resumable()).isEmpty();
    accepted(order(MissionAction.GOTO).uid("3"), "pursuing goal \"3\"");
    accepted(order(MissionAction.RESUME), "resumed at [2]");
  }

  @Test
  void goTo_missionHasGoneOnSince_thereIsNothingToResume() {
    kit.with("LOOP", true).start(MissionManager::new);
    accepted(order(MissionAction.GOTO).uid("2"), "pursuing goal \"2\"");
    run("2", "3");
    assertThat(report().resumable()).isEmpty();
    refused(order(MissionAction.RESUME), "nothing to resume: the mission was not interrupted");
  }

  @Test
  void goTo_againAfterTheMissionHasGoneOn_resumeGoesBackToBeforeTheSecond() {
    kit.with("LOOP", true).start(MissionManager::new);
    accepted(order(MissionAction.GOTO).uid("2"), "pursuing goal \"2\"");
    run("2", "3", "1");
    kit.advance(1.0); // no goal is reached twice at one moment
    run("2");
    accepted(order(MissionAction.GOTO).uid("1"), "pursuing goal \"1\"");
    accepted(order(MissionAction.RESUME), "resumed at [3]");
  }

  @Test
  void goTo_twiceInARow_resumeGoesBackToBeforeTheFirst() {
    kit.start(MissionManager::new);
    complete("1");
    accepted(order(MissionAction.GOTO).uid("3"), "pursuing goal \"3\"");
    accepted(order(MissionAction.GOTO).uid("1"), "pursuing goal \"1\"");
    accepted(order(MissionAction.RESUME), "resumed at [2]");
  }

  @Test
  void goTo_unknownName_isRefusedWithTheNames() {
    kit.start(MissionManager::new);
    refused(order(MissionAction.GOTO).uid("4"), "no goal \"4\"; expected one of 1, 2, 3");
  }

  @Test
  void resume_missionThatWasNotLeft_isRefused() {
    kit.start(MissionManager::new);
    refused(order(MissionAction.RESUME), "nothing to resume: the mission was not interrupted");
  }

  @Test
  void skip_currentGoal_goesOnAndSaysWhoSkippedIt() {
    kit.start(MissionManager::new);
    accepted(order(MissionAction.SKIP), "goal \"1\" skipped; current: 2");

    GoalInformation skipped = report().goals().get(0);
    assertThat(skipped.result()).contains(GoalResult.SKIPPED);
    assertThat(skipped.reason()).contains("skipped by anna");
    refused(order(MissionAction.SKIP).uid("3"), "goal \"3\" is not current; current: 2");
  }

  @Test
  void skip_overMission_isRefused() {
    kit.start(MissionManager::new);
    run("1", "2", "3");
    refused(order(MissionAction.SKIP), "the mission is over: no goal to skip");
  }

  @Test
  void order_isLoggedWithItsOperator() {
    kit.start(MissionManager::new);
    give(order(MissionAction.SKIP));
    give(order(MissionAction.RESUME));

    assertThat(logged("SKIP by anna: goal \"1\" skipped")).isTrue();
    assertThat(logged("RESUME by anna refused: nothing to resume")).isTrue();
  }

  @Test
  void request_saysHowTheMissionStands() throws IOException {
    Files.writeString(
        file,
        "<mission><timeLimit>60</timeLimit><waypoint><x>1</x></waypoint><waypoint><x>2</x></waypoint></mission>");
    kit.start(MissionManager::new);
    kit.advance(5.0);
    MissionReport report = report();

    assertThat(report.mission()).isEqualTo(file.toString());
    assertThat(report.goals()).extracting(GoalInformation::uid).containsExactly("1", "2");
    assertThat(report.current()).containsExactly("1");
    assertThat(report.upcoming()).containsExactly("2");
    assertThat(report.sequence()).containsExactly("1", "2");
    assertThat(report.timeLimit()).hasValue(60.0);
    assertThat(report.elapsed()).isEqualTo(5.0);
    assertThat(report.began()).hasValue(0L);
    assertThat(report.resumable()).isEmpty();
    assertThat(report.failsafe()).isEmpty();
  }

  @Test
  void land_withALandMission_endsThereAndResumeGoesBack() throws IOException {
    Files.writeString(
        directory.resolve("land.xml"),
        "<mission><waypoint><name>final</name><next>runway</next><x>5</x></waypoint><waypoint><name>runway</name><x>6</x></waypoint></mission>");
    kit.with("LAND MISSION", directory.resolve("land.xml").toString());
    kit.start(MissionManager::new);
    complete("1");
    accepted(order(MissionAction.LAND), "pursuing goal \"LAND final\"");
    run("LAND final", "LAND runway");
    assertThat(current()).isEmpty();
    accepted(order(MissionAction.LAND), "pursuing goal \"LAND final\"");
  }

  @Test
  void land_withoutALandMission_isRefused() {
    kit.start(MissionManager::new);
    refused(
        order(MissionAction.LAND),
        "the Mission Manager has no LAND MISSION, and the mission no landingStart");
  }

  @Test
  void return_rallyPointNearerThanHome_goesThereAndResumesTheMission() {
    kit.start(MissionManager::new);
    Waypoint far = new Waypoint().uid("rally 1").x(9.0).y(9.0).horizontalThreshold(1.0);
    Waypoint near = new Waypoint().uid("rally 2").x(1.0).y(1.1).z(60.0).horizontalThreshold(1.0);
    kit.publish(Channels.FENCE, new FenceState().rally(List.of(far, near)));
    kit.publish(Channels.STATE, new StateInformation().x(1.0).y(1.0));

    accepted(order(MissionAction.RETURN), "pursuing goal \"RETURN rally 2\"");

    assertThat(current()).containsExactly("RETURN rally 2");
    accepted(order(MissionAction.RESUME), "resumed at [1]");
  }

  /** As a broker may deliver them (QoS 1), the second time to a restarted Mission Manager. */
  @Test
  void goalCommandAndUpdate_thatArriveAgain_haveNoEffect() {
    MissionManager manager = kit.start(MissionManager::new);
    GoalCommand command = new GoalCommand().uid("3");
    Waypoint update = new Waypoint().uid("1").x(77.0).y(1.0).horizontalThreshold(1.0);
    kit.publish(Channels.GOAL_COMMANDS, command);
    kit.publish(Channels.GOAL_UPDATES, update);
    kit.advance(1.0);
    kit.publish(Channels.GOAL_UPDATES, update.copy().x(78.0));
    kit.publish(Channels.GOAL_COMMANDS, new GoalCommand().uid("1"));

    kit.restart(manager, MissionManager::new);
    kit.publish(Channels.GOAL_COMMANDS, command);
    kit.publish(Channels.GOAL_UPDATES, update);

    assertThat(current()).containsExactly("1");
    GoalList goals = kit.latest(Channels.GOALS).orElseThrow();
    assertThat(((Waypoint) goals.goals().get(0)).x()).hasValue(78.0);
  }
}
