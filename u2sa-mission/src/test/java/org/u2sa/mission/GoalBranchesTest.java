package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.mission.GoalSequence.Options;
import org.u2sa.service.handover.HandOver;

/** Which goals come next, by what came of the ones before. */
class GoalBranchesTest {
  private static GoalSequence sequence(String goals) {
    return new GoalSequence(MissionTest.mission(goals).goals(), false, Options.ALL);
  }

  private static String goal(String name, String links) {
    return "<waypoint><name>" + name + "</name><x>1</x>" + links + "</waypoint>\n";
  }

  private static String current(GoalSequence sequence) {
    return sequence.current().stream().map(GoalInformation::uid).collect(Collectors.joining(","));
  }

  private static String after(GoalSequence sequence, String uid, GoalResult result) {
    assertThat(sequence.finish(uid, result, Optional.empty(), "", 0)).as(uid).isTrue();
    return current(sequence);
  }

  private static final String FORK =
      goal(
              "a",
              "<timeLimit>9</timeLimit><next>b</next><next if='failed'>c</next><next if='timed-out'>d</next>")
          + goal("b", "")
          + goal("c", "")
          + goal("d", "");

  @Test
  void finish_byResult_followsTheListOfThatResult() {
    assertThat(after(sequence(FORK), "a", GoalResult.DONE)).isEqualTo("b");
    assertThat(after(sequence(FORK), "a", GoalResult.FAILED)).isEqualTo("c");
    assertThat(after(sequence(FORK), "a", GoalResult.TIMED_OUT)).isEqualTo("d");
    assertThat(after(sequence(FORK), "a", GoalResult.SKIPPED)).isEqualTo("b");
  }

  @Test
  void finish_timedOutWithoutAListOfItsOwn_hasFailed() {
    GoalSequence sequence =
        sequence(
            goal("a", "<timeLimit>9</timeLimit><next>b</next><next if='failed'>c</next>")
                + goal("b", "")
                + goal("c", ""));

    assertThat(after(sequence, "a", GoalResult.TIMED_OUT)).isEqualTo("c");
  }

  @Test
  void finish_failedWithoutAnyOtherList_goesOnAsIfDone() {
    GoalSequence sequence = sequence(goal("a", "<next>c</next>") + goal("b", "") + goal("c", ""));

    assertThat(after(sequence, "a", GoalResult.FAILED)).isEqualTo("c");
  }

  @Test
  void finish_branchInAMissionInTheOrderOfTheFile_othersFollowTheFile() {
    GoalSequence sequence =
        sequence(goal("a", "<next if='failed'>c</next>") + goal("b", "") + goal("c", ""));

    assertThat(current(sequence)).isEqualTo("a");
    assertThat(after(sequence, "a", GoalResult.DONE)).isEqualTo("b");
    assertThat(after(sequence, "b", GoalResult.FAILED)).isEqualTo("c");
  }

  @Test
  void finish_endIfFailed_endsTheMission() {
    GoalSequence sequence = sequence(goal("a", "<end if='failed'/>") + goal("b", ""));

    assertThat(after(sequence, "a", GoalResult.FAILED)).isEmpty();
    assertThat(sequence.isOver()).isTrue();
  }

  @ParameterizedTest
  @EnumSource(Options.class)
  void finish_endIfTimedOutWithLoop_endsTheMissionForGood(Options options) {
    GoalSequence sequence =
        sequence(
            goal("a", "")
                + goal("b", "<timeLimit>3</timeLimit><end if='timed out'/>")
                + goal("c", ""));
    sequence.rules(true, options);
    after(sequence, "a", GoalResult.DONE);

    assertThat(after(sequence, "b", GoalResult.TIMED_OUT)).isEmpty();
  }

  @Test
  void finish_endOfOneOfSeveralAny_endsTheMission() {
    GoalSequence sequence =
        sequence(
            goal("a", "<next>b, c</next>")
                + goal("b", "<timeLimit>3</timeLimit><next>d</next><end if='timed out'/>")
                + goal("c", "<next>d</next>")
                + goal("d", ""));
    sequence.rules(true, Options.ANY);
    after(sequence, "a", GoalResult.DONE);

    assertThat(after(sequence, "b", GoalResult.TIMED_OUT)).isEmpty();
  }

  @Test
  void finish_endOfOneOfSeveralAll_endsOnceAllAreFinishedUnlessAnotherNamesWhatFollows() {
    String mission =
        goal("a", "<next>b, c</next>") + goal("b", "<end if='failed'/>") + goal("c", "%s");
    GoalSequence ends = sequence(mission.replace("%s", ""));
    ends.rules(true, Options.ALL);
    after(ends, "a", GoalResult.DONE);
    assertThat(after(ends, "b", GoalResult.FAILED)).isEqualTo("c");
    GoalSequence handedOver = handedOver(ends, true, Options.ALL);
    assertThat(after(ends, "c", GoalResult.DONE)).isEmpty();
    assertThat(after(handedOver, "c", GoalResult.DONE)).isEmpty();

    GoalSequence goesOn = sequence(mission.replace("%s", "<next>d</next>") + goal("d", ""));
    goesOn.rules(true, Options.ALL);
    after(goesOn, "a", GoalResult.DONE);
    after(goesOn, "b", GoalResult.FAILED);
    assertThat(after(goesOn, "c", GoalResult.DONE)).isEqualTo("d");
    assertThat(after(goesOn, "d", GoalResult.DONE)).as("a new lap").isEqualTo("a");
  }

  @Test
  void finish_anyWithoutNext_endsTheMissionOrBeginsAnotherLap() {
    String mission = goal("a", "<next>b, c</next>") + goal("b", "") + goal("c", "");
    GoalSequence once = sequence(mission);
    once.rules(false, Options.ANY);
    after(once, "a", GoalResult.DONE);
    assertThat(after(once, "b", GoalResult.DONE)).isEmpty();

    GoalSequence laps = sequence(mission);
    laps.rules(true, Options.ANY);
    after(laps, "a", GoalResult.DONE);
    assertThat(after(laps, "c", GoalResult.DONE)).isEqualTo("a");
  }

  private static GoalSequence handedOver(GoalSequence from, boolean loop, Options options) {
    HandOver state = new HandOver("MissionManager");
    from.handOver(state, "MISSION");
    return GoalSequence.takenOver(state, "MISSION", loop, options).orElseThrow();
  }

  @Test
  void finish_repeat_goesBackThatOftenAndThenOn() {
    GoalSequence sequence =
        sequence(goal("a", "") + goal("b", "<repeat from='a' times='2'/>") + goal("c", ""));
    StringBuilder seen = new StringBuilder();
    for (int i = 0; i < 7; i++) {
      seen.append(current(sequence));
      after(sequence, current(sequence), GoalResult.DONE);
    }

    assertThat(seen).hasToString("abababc");
    assertThat(sequence.book.timesFinished("a")).isEqualTo(3);
  }

  @Test
  void finish_repeatWithinARepeat_countsAnewEachTime() {
    GoalSequence sequence =
        sequence(
            goal("a", "<repeat from='a' times='1'/>") + goal("b", "<repeat from='a' times='1'/>"));
    StringBuilder seen = new StringBuilder();
    while (!sequence.isOver()) {
      seen.append(current(sequence));
      after(sequence, current(sequence), GoalResult.DONE);
    }

    assertThat(seen).hasToString("aabaab");
  }

  @Test
  void finish_branchOutOfARepetition_leavesIt() {
    GoalSequence sequence =
        sequence(
            goal("a", "<repeat from='a' times='9'/><next if='failed'>c</next>")
                + goal("b", "")
                + goal("c", ""));
    after(sequence, "a", GoalResult.DONE);

    assertThat(after(sequence, "a", GoalResult.FAILED)).isEqualTo("c");
  }

  @Test
  void finish_chooseTwoOfThree_goesOnAfterTwoAreDone() {
    String mission =
        goal("a", "<next>b, c, d</next><choose>2</choose>")
            + goal("b", "<next>e</next>")
            + goal("c", "<next>e</next>")
            + goal("d", "<next>e</next>")
            + goal("e", "");
    GoalSequence sequence = sequence(mission);

    assertThat(after(sequence, "a", GoalResult.DONE)).isEqualTo("b,c,d");
    assertThat(after(sequence, "c", GoalResult.DONE)).isEqualTo("b,d");
    assertThat(after(sequence, "d", GoalResult.FAILED)).isEqualTo("b");
    assertThat(after(sequence, "b", GoalResult.DONE)).isEqualTo("e");
    assertThat(after(sequence, "e", GoalResult.DONE)).isEmpty();
  }

  @ParameterizedTest
  @EnumSource(Options.class)
  void finish_chooseAsManyAsThereAre_allAreDone(Options options) {
    GoalSequence sequence =
        sequence(
            goal("a", "<next>b, c</next><choose>2</choose>")
                + goal("b", "<next>e</next>")
                + goal("c", "<next>e</next>")
                + goal("e", ""));
    sequence.rules(false, options);

    assertThat(after(sequence, "a", GoalResult.DONE)).isEqualTo("b,c");
    assertThat(after(sequence, "b", GoalResult.DONE)).isEqualTo("c");
    assertThat(after(sequence, "c", GoalResult.DONE)).isEqualTo("e");
  }

  @Test
  void finish_chooseOneThatIsDone_theOthersAreLeft() {
    GoalSequence sequence =
        sequence(
            goal("a", "<next>b, c</next><choose>1</choose>")
                + goal("b", "<next>e</next>")
                + goal("c", "")
                + goal("e", ""));
    after(sequence, "a", GoalResult.DONE);

    assertThat(sequence.upcoming()).extracting(GoalInformation::uid).containsExactly("e");
    assertThat(after(sequence, "b", GoalResult.DONE)).isEqualTo("e");
  }

  @Test
  void upcoming_inARepetition_isWhereItGoesBackToAndCountsNothing() {
    GoalSequence sequence =
        sequence(goal("a", "") + goal("b", "<repeat from='a' times='1'/>") + goal("c", ""));
    after(sequence, "a", GoalResult.DONE);
    for (int i = 0; i < 3; i++) {
      assertThat(sequence.upcoming()).extracting(GoalInformation::uid).containsExactly("a");
    }

    assertThat(after(sequence, "b", GoalResult.DONE)).isEqualTo("a");
  }

  @Test
  void warnings_loopThatAResultLeaves_none() {
    String loop =
        goal("a", "<next>b</next><next if='failed'>c</next>")
            + goal("b", "<next>a</next>")
            + goal("c", "");

    assertThat(MissionTest.mission(loop).warnings()).isEmpty();
  }

  @Test
  void warnings_loopWithoutExit_namesItsGoals() {
    String loop =
        goal("a", "<next>b</next>") + goal("b", "<next>c</next>") + goal("c", "<next>b</next>");

    assertThat(MissionTest.mission(loop).warnings())
        .containsExactly(
            "m.xml, line 2, <waypoint>: a loop without an exit: no <next> leads from a, b, c to an end of the mission");
    assertThat(MissionTest.mission("<timeLimit>60</timeLimit>" + loop).warnings()).isEmpty();
    assertThat(
            MissionTest.mission(loop.replace("<next>c</next>", "<next>c</next><end if='failed'/>"))
                .warnings())
        .isEmpty();
  }

  @Test
  void warnings_goalThatOnlyAFailureLeadsTo_isReachable() {
    assertThat(MissionTest.mission(FORK).warnings()).isEmpty();
  }

  @Test
  void next_home_isKnownIfTheMissionHasOne() {
    String home = "<home><x>8</x><y>50</y></home>";
    Mission mission =
        MissionTest.mission(home + goal("a", "<next if='failed'>home</next>") + goal("b", ""));

    assertThat(mission.goals().get(0).nextIf(GoalResult.FAILED)).contains(List.of("home"));
    assertThat(mission.warnings()).isEmpty();
  }

  @Test
  void timeLimits_withUnits_areInSeconds() {
    Mission mission =
        MissionTest.mission(
            "<timeLimit unit='min' next='b'>2</timeLimit>"
                + goal("a", "<timeLimit unit='ms'>1500</timeLimit>")
                + goal("b", ""));

    assertThat(mission.timeLimit()).hasValue(120.0);
    assertThat(mission.limit().orElseThrow().next()).containsExactly("b");
    assertThat(mission.goals().get(0).timeLimit()).hasValue(1.5);
  }
}
