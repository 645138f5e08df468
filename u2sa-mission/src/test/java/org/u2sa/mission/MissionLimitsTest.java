package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.mission.MissionRequest;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;

/** What a MissionManager does when time is up, and what it says of goals that are over. */
class MissionLimitsTest extends ThreeWaypoints {
  private void write(String content) throws IOException {
    Files.writeString(file, "<mission>" + content + "</mission>");
  }

  private static String goal(String name, String more) {
    return "<waypoint><name>" + name + "</name><x>1</x><y>1</y>" + more + "</waypoint>";
  }

  private MissionReport report() {
    kit.publish(Channels.MISSION, new MissionRequest().requestId("r"));
    return (MissionReport) kit.latest(Channels.MISSION).orElseThrow();
  }

  private GoalInformation goalOf(String uid) {
    return report().goals().stream()
        .filter(goal -> goal.uid().equals(uid))
        .findFirst()
        .orElseThrow();
  }

  private void armed(boolean armed) {
    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(armed));
  }

  @Test
  void step_goalsTimeIsUp_followsTheBranchAndSaysWhy() throws IOException {
    write(
        goal("a", "<timeLimit>10</timeLimit><next if='timed out'>c</next>")
            + goal("b", "")
            + goal("c", ""));
    kit.start(MissionManager::new);
    kit.advance(9.8);
    assertThat(current()).containsExactly("a");
    kit.advance(0.4);

    assertThat(current()).containsExactly("c");
    GoalInformation late = goalOf("a");
    assertThat(late.result()).contains(GoalResult.TIMED_OUT);
    assertThat(late.abandoned()).isTrue();
    assertThat(late.reason()).contains("not done within 10.0 s");
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.0, 1.0e-9})
  @Timeout(20)
  void update_noTimeAtAllForAGoalThatLoops_timesOutOnceAStep(double limitS) throws IOException {
    write(goal("a", ""));
    kit.with("LOOP", true).start(MissionManager::new);
    kit.publish(
        Channels.GOAL_UPDATES,
        new Waypoint().uid("a").x(1.0).y(1.0).horizontalThreshold(5.0).timeLimit(limitS));
    kit.advance(1.0);
    assertThat(current()).containsExactly("a");
    assertThat(kit.log("MissionManager").stream().filter(line -> line.contains("timed out")))
        .hasSizeBetween(1, 10);
  }

  @Test
  void step_goalOfALaterLap_hasItsWholeTimeAgain() throws IOException {
    write(goal("a", "<timeLimit>10</timeLimit><repeat from='a' times='1'/>") + goal("b", ""));
    kit.start(MissionManager::new);
    kit.advance(8.0);
    complete("a");
    kit.advance(8.0);
    assertThat(current()).containsExactly("a");

    kit.advance(2.4);
    assertThat(current()).containsExactly("b");
  }

  @Test
  void step_vehicleIsNotArmed_timeStands() throws IOException {
    write(goal("a", "<timeLimit>10</timeLimit>") + goal("b", ""));
    kit.start(MissionManager::new);
    armed(false);
    kit.advance(60.0);
    assertThat(current()).containsExactly("a");

    armed(true);
    kit.advance(10.4);
    assertThat(current()).containsExactly("b");
  }

  @Test
  void step_aFailsafeIsFlown_timeStandsForTheMission() throws IOException {
    write(
        "<home><x>8</x><y>50</y></home>" + goal("a", "<timeLimit>10</timeLimit>") + goal("b", ""));
    kit.start(MissionManager::new);
    kit.publish(Channels.FAILSAFE, new FailsafeState().action(FailsafeAction.RETURN));
    kit.advance(60.0);
    assertThat(current()).containsExactly("RETURN home");
    kit.publish(Channels.FAILSAFE, new FailsafeState().action(FailsafeAction.CONTINUE));

    assertThat(current()).containsExactly("a");
    kit.advance(10.4);
    assertThat(current()).containsExactly("b");
  }

  @Test
  void step_missionsTimeIsUp_goesWhereTheLimitSays() throws IOException {
    write(
        "<timeLimit unit='min' next='home'>1</timeLimit><home><x>8</x><y>50</y></home>"
            + goal("a", "")
            + goal("b", ""));
    kit.start(MissionManager::new);
    kit.advance(30.0);
    complete("a");
    kit.advance(30.4);

    assertThat(current()).containsExactly("home");
    assertThat(goalOf("b").result()).contains(GoalResult.TIMED_OUT);
    complete("home");
    assertThat(current()).isEmpty();
    kit.advance(120.0);
    assertThat(current()).isEmpty();
  }

  @Test
  void step_missionsTimeIsUpAtTheGoalThatTheLimitNames_goesOnThere() throws IOException {
    write("<timeLimit next='b'>20</timeLimit>" + goal("a", "") + goal("b", ""));
    kit.with("LOOP", true).start(MissionManager::new);
    complete("a");
    kit.advance(20.4);

    assertThat(current()).containsExactly("b");
    assertThat(goalOf("b").result()).isEmpty();
    complete("b");
    assertThat(current()).isEmpty();
  }

  @Test
  void step_missionsTimeIsUpInALoop_isOver() throws IOException {
    write("<timeLimit>20</timeLimit>" + goal("a", "<next>a</next>"));
    kit.with("LOOP", true).start(MissionManager::new);
    complete("a");
    kit.advance(20.4);

    assertThat(current()).isEmpty();
    assertThat(logged("the mission's time limit of 20.0 s has passed")).isTrue();
  }

  @Test
  void restart_twiceWithinAGoalAndOnceDisarmed_countsTheArmedTime() throws IOException {
    write(goal("a", "<timeLimit>20</timeLimit>") + goal("b", ""));
    MissionManager first = kit.start(MissionManager::new);
    armed(true);
    kit.advance(6.0);
    MissionManager second = kit.restart(first, MissionManager::new);
    kit.advance(6.0);
    armed(false);
    kit.advance(30.0);
    kit.restart(second, MissionManager::new);
    armed(true);
    kit.advance(7.7);
    assertThat(current()).containsExactly("a");
    kit.advance(0.6);

    assertThat(current()).containsExactly("b");
  }

  @Test
  void restart_inTheMiddle_timeGoesOn() throws IOException {
    write(goal("a", "<timeLimit>10</timeLimit>") + goal("b", ""));
    MissionManager before = kit.start(MissionManager::new);
    kit.advance(4.0);
    kit.publish(Channels.GOAL_UPDATES, report("b")); // so that it is remembered at 4 s
    kit.advance(4.0);

    kit.restart(before, MissionManager::new);
    kit.advance(2.4);

    assertThat(current()).containsExactly("b");
  }

  @Test
  void report_completedGoal_carriesWhatThePlannerChanged() {
    kit.start(MissionManager::new);
    kit.advance(7.0);
    kit.publish(
        Channels.GOAL_REPORTS,
        report("1").psi(1.25).completed(true).description("gate seen").next(List.of("3")));

    GoalInformation done = goalOf("1");
    assertThat(((Waypoint) done).psi()).hasValue(1.25);
    assertThat(done.description()).contains("gate seen");
    assertThat(done.result()).contains(GoalResult.DONE);
    assertThat(done.arrivedAt()).hasValue(7_000_000L);
    assertThat(done.next()).isEmpty(); // the order is the Mission Manager's
    assertThat(current()).containsExactly("2");
  }

  @Test
  void report_timeOfArrivalThatThePlannerSet_stays() {
    kit.start(MissionManager::new);
    kit.advance(7.0);
    kit.publish(Channels.GOAL_REPORTS, report("1").arrivedAt(5_000_000L).completed(true));

    assertThat(goalOf("1").arrivedAt()).hasValue(5_000_000L);
  }

  @Test
  void report_goalGivenUp_carriesThePlannersReason() {
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_REPORTS, report("1").abandoned(true).reason("walled in"));

    assertThat(goalOf("1").reason()).contains("walled in");
    assertThat(goalOf("1").result()).contains(GoalResult.FAILED);
    assertThat(goalOf("1").arrivedAt()).isEmpty();
    assertThat(logged("abandoned by the planner: walled in")).isTrue();
  }

  @Test
  void report_goalPursuedOnceMore_beginsAsItIsDefined() throws IOException {
    write(goal("a", "<repeat from='a' times='1'/>"));
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_REPORTS, report("a").psi(1.25).completed(true));

    GoalInformation again = goals().goals().get(0);
    assertThat(((Waypoint) again).psi()).isEmpty();
    assertThat(again.completed()).isFalse();
    assertThat(again.result()).isEmpty();
    assertThat(report().finished()).containsExactly(1.0);
  }
}
