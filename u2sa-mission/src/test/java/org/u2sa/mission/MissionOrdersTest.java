package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.mission.MissionRequest;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.schema.U2SAData;

/** What operators order of a running mission, and what they are answered. */
class MissionOrdersTest extends ThreeWaypoints {
  private int orders;

  private static MissionOrder order(MissionAction action) {
    return new MissionOrder().action(action).operator("anna");
  }

  private static MissionOrder goals(MissionAction action, String goals) {
    return order(action).file("more.xml").goals("<mission>\n" + goals + "\n</mission>");
  }

  private MissionOrderResult give(MissionOrder order) {
    if (!order.isFrozen()) {
      order.requestId("order " + ++orders);
    }
    kit.publish(Channels.MISSION, order);
    MissionOrderResult result = (MissionOrderResult) kit.latest(Channels.MISSION).orElseThrow();
    assertThat(result.requestId()).isEqualTo(order.requestId());
    return result;
  }

  private void accepted(MissionOrder order, String outcome) {
    MissionOrderResult result = give(order);
    assertThat(result.outcome()).isEqualTo(outcome);
    assertThat(result.accepted()).isTrue();
  }

  private void refused(MissionOrder order, String why) {
    List<String> before = current();
    MissionOrderResult result = give(order);
    assertThat(result.outcome()).isEqualTo(why);
    assertThat(result.accepted()).isFalse();
    assertThat(current()).isEqualTo(before);
  }

  private MissionReport report() {
    kit.publish(Channels.MISSION, new MissionRequest().requestId("r"));
    return (MissionReport) kit.latest(Channels.MISSION).orElseThrow();
  }

  private void run(String... uids) {
    for (String uid : uids) {
      assertThat(current()).containsExactly(uid);
      complete(uid);
    }
  }

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
  void skip_thatTheNetworkBringsTwice_isObeyedOnceAndAnsweredTwice() {
    kit.start(MissionManager::new);
    MissionOrder once = order(MissionAction.SKIP);
    assertThat(give(once).accepted()).isTrue();
    int answers = kit.published(Channels.MISSION).size();
    assertThat(give(once).accepted()).isTrue();

    assertThat(kit.published(Channels.MISSION)).hasSize(answers + 1);
    assertThat(current()).containsExactly("2");
  }

  @Test
  void skip_overMission_isRefused() {
    kit.start(MissionManager::new);
    run("1", "2", "3");
    refused(order(MissionAction.SKIP), "the mission is over: no goal to skip");
  }

  @Test
  void insert_afterTheCurrentGoal_isPursuedNextAndThenTheRest() {
    kit.start(MissionManager::new);
    accepted(
        goals(
            MissionAction.INSERT,
            "<waypoint><name>a</name><x>5</x></waypoint><waypoint><x>6</x></waypoint>"),
        "inserted \"a\", \"4\" after \"1\"");
    assertThat(goals().upcoming()).extracting(GoalInformation::uid).containsExactly("a");
    run("1", "a", "4", "2", "3");
    assertThat(current()).isEmpty();
  }

  @Test
  void insert_afterTheLastGoal_prolongsTheMission() {
    kit.start(MissionManager::new);
    accepted(
        goals(MissionAction.INSERT, "<waypoint><name>a</name><x>5</x></waypoint>").uid("3"),
        "inserted \"a\" after \"3\"");
    run("1", "2", "3", "a");
    assertThat(current()).isEmpty();
  }

  @Test
  void insert_now_interruptsTheCurrentGoal() {
    kit.start(MissionManager::new);
    complete("1");
    accepted(
        goals(MissionAction.INSERT, "<waypoint><name>a</name><x>5</x></waypoint>").now(true),
        "pursuing \"a\", then 2");
    run("a", "2", "3");
    assertThat(current()).isEmpty();
  }

  @Test
  void insert_goalWithoutARequiredField_isRefusedAndTheMissionGoesOn() {
    kit.start(MissionManager::new);
    refused(
        goals(MissionAction.INSERT, "<objectGoal><name>a</name></objectGoal>"),
        "more.xml, line 2, <objectGoal>: lacks <objectType>; expected a value");
    run("1", "2", "3");
    assertThat(current()).isEmpty();
  }

  @Test
  void insert_goalsThatBranch_leadIntoTheMission() {
    kit.start(MissionManager::new);
    accepted(
        goals(
            MissionAction.INSERT,
            "<waypoint><name>a</name><x>5</x><next>b</next><next if='failed'>3</next></waypoint>"
                + "<waypoint><name>b</name><x>6</x></waypoint>"),
        "inserted \"a\", \"b\" after \"1\"");
    complete("1");
    kit.publish(Channels.GOAL_REPORTS, report("a").abandoned(true));

    assertThat(current()).containsExactly("3");
  }

  private void write(String goals) throws IOException {
    Files.writeString(file, "<mission>" + goals + "</mission>");
  }

  @Test
  void insert_afterAGoalWithAChoice_theChoiceIsMadeAfterTheInsertedGoal() throws IOException {
    write(
        "<waypoint><name>a</name><x>1</x><next>b, c, d</next><choose>2</choose></waypoint>"
            + "<waypoint><name>b</name><x>2</x><next>e</next></waypoint>"
            + "<waypoint><name>c</name><x>3</x><next>e</next></waypoint>"
            + "<waypoint><name>d</name><x>4</x><next>e</next></waypoint>"
            + "<waypoint><name>e</name><x>5</x></waypoint>");
    kit.start(MissionManager::new);
    accepted(
        goals(
            MissionAction.INSERT,
            "<waypoint><name>y</name><x>6</x></waypoint><waypoint><name>z</name><x>6</x></waypoint>"),
        "inserted \"y\", \"z\" after \"a\"");
    run("a", "y", "z");
    assertThat(current()).containsExactly("b", "c", "d");
    complete("b");
    complete("d");

    assertThat(current()).containsExactly("e");
  }

  private static final String OPTIONS =
      "<waypoint><name>b</name><x>2</x><next>e</next></waypoint>"
          + "<waypoint><name>c</name><x>3</x><next>e</next></waypoint>"
          + "<waypoint><name>d</name><x>4</x><next>e</next></waypoint>"
          + "<waypoint><name>e</name><x>5</x></waypoint>";

  @ParameterizedTest
  @ValueSource(strings = {"", "<choose>2</choose>"})
  void insert_afterOneOfSeveralOptions_whatFollowsThemComesOnceAfterwards(String choice)
      throws IOException {
    write(
        "<waypoint><name>a</name><x>1</x><next>b, c, d</next>" + choice + "</waypoint>" + OPTIONS);
    kit.start(MissionManager::new);
    complete("a");
    complete("c");
    accepted(
        goals(MissionAction.INSERT, "<waypoint><name>z</name><x>6</x></waypoint>").uid("b"),
        "inserted \"z\" after \"b\", \"c\", \"d\"");
    complete("b");
    if (choice.isEmpty()) {
      complete("d");
    }

    run("z", "e");
    assertThat(current()).isEmpty();
  }

  @Test
  void insert_afterAnOptionOfWhichAnyCounts_leavesTheOthersAsTheyAre() throws IOException {
    write("<waypoint><name>a</name><x>1</x><next>b, c, d</next></waypoint>" + OPTIONS);
    kit.with("OPTIONS", "ANY").start(MissionManager::new);
    accepted(
        goals(MissionAction.INSERT, "<waypoint><name>z</name><x>6</x></waypoint>").uid("b"),
        "inserted \"z\" after \"b\"");
    complete("a");
    complete("c");

    assertThat(current()).containsExactly("e");
  }

  @Test
  void insert_afterAGoalThatEndsALoopingMission_theMissionEndsAfterTheInsertedGoal()
      throws IOException {
    write(
        "<waypoint><name>a</name><x>1</x><next>b</next></waypoint>"
            + "<waypoint><name>b</name><x>2</x><end if='done'/></waypoint>");
    kit.with("LOOP", true).start(MissionManager::new);
    accepted(
        goals(MissionAction.INSERT, "<waypoint><name>z</name><x>6</x></waypoint>").uid("b"),
        "inserted \"z\" after \"b\"");
    run("a", "b", "z");

    assertThat(current()).isEmpty();
  }

  @Test
  void insertAndUpdate_moreThanCanBePublished_areRefused() {
    kit.start(MissionManager::new);
    String text = "<description>" + "x".repeat(60_000) + "</description>";
    for (int i = 0; i < 5; i++) {
      accepted(
          goals(MissionAction.INSERT, "<waypoint><x>5</x>" + text + "</waypoint>"),
          "inserted \"" + (4 + i) + "\" after \"1\"");
    }
    String why = "the mission's goals would be too long to publish";
    refused(goals(MissionAction.INSERT, "<waypoint><x>5</x>" + text + "</waypoint>"), why);
    refused(goals(MissionAction.UPDATE, "<waypoint><name>2</name>" + text + "</waypoint>"), why);
    accepted(
        goals(MissionAction.INSERT, "<waypoint><x>5</x></waypoint>"), "inserted \"9\" after \"1\"");
  }

  @Test
  void goalUpdates_asManyAsAreTaken_leaveRoomForOperatorsOrders() {
    String text = "<description>" + "x".repeat(60_000) + "</description>";
    kit.start(MissionManager::new);
    for (int i = 0; i < 10; i++) {
      Waypoint invented = new Waypoint().uid("invented " + i).horizontalThreshold(1.0);
      invented.x(5.0).y(5.0);
      kit.publish(Channels.GOAL_UPDATES, invented.description("x".repeat(60_000)));
    }

    assertThat(kit.log("MissionManager"))
        .anyMatch(line -> line.contains("refused: the goals would be too long to publish"));
    accepted(
        goals(MissionAction.INSERT, "<waypoint><x>5</x>" + text + "</waypoint>"),
        "inserted \"4\" after \"1\"");
  }

  @Test
  void insert_wrongGoals_areRefusedWithFileAndLine() {
    kit.start(MissionManager::new);
    refused(
        goals(MissionAction.INSERT, "<waypoint><name>2</name><x>5</x></waypoint>"),
        "more.xml, line 2, <name>: the mission has a goal \"2\"; expected another name, or update");
    refused(
        goals(MissionAction.INSERT, "<waypoint><x>500</x></waypoint>"),
        "more.xml, line 2, <x>: 500.0 is outside -180.0…180.0 deg of longitude");
    refused(
        goals(MissionAction.INSERT, "<waypoint><x>5</x><next>9</next></waypoint>"),
        "more.xml, line 2, <next>: \"9\" names no goal; the goals are 4, 1, 2, 3");
    refused(
        goals(
            MissionAction.INSERT,
            "<waypoint><reference>Local ENU</reference><x>5</x><y>2</y></waypoint>"),
        "more.xml, line 2, <reference>: is in LOCAL_ENU, but the mission's waypoint \"1\" is in GLOBAL; expected all on the earth or all on a local plane");
    refused(
        goals(MissionAction.INSERT, "<home><x>1</x><y>1</y></home><waypoint><x>5</x></waypoint>"),
        "more.xml, line 2, <home>: belongs to a whole mission; expected goals only");
    refused(order(MissionAction.INSERT), "no goals; expected a mission in XML");
  }

  @Test
  void insert_afterAGoalThatWillNotCome_isRefused() {
    kit.start(MissionManager::new);
    complete("1");
    refused(
        goals(MissionAction.INSERT, "<waypoint><x>5</x></waypoint>").uid("1"),
        "goal \"1\" is not a successor of a current goal, so nothing after it would be reached; current: 2; expected one of what follows, or insertion now");
  }

  @Test
  void insert_unnamedGoalsAmongNamedOnes_getTheNextFreeNumbers() {
    kit.start(MissionManager::new);
    accepted(
        goals(
            MissionAction.INSERT,
            "<waypoint><x>5</x></waypoint><waypoint><name>5</name><x>5</x></waypoint>"
                + "<waypoint><x>5</x></waypoint><waypoint><x>5</x></waypoint>"),
        "inserted \"4\", \"5\", \"6\", \"7\" after \"1\"");
  }

  @Test
  void insert_anyHowOften_namesStayApart() {
    kit.start(MissionManager::new);
    for (int i = 0; i < 3; i++) {
      assertThat(give(goals(MissionAction.INSERT, "<waypoint><x>5</x></waypoint>")).outcome())
          .startsWith("inserted ");
    }

    assertThat(report().goals()).extracting(GoalInformation::uid).doesNotHaveDuplicates();
  }

  @Test
  void update_goalThatIsPursued_isPublishedWithTheNewFieldsAndTheOldRest() {
    kit.start(MissionManager::new);
    accepted(
        goals(
            MissionAction.UPDATE,
            "<waypoint><name>1</name><y>44</y><timeLimit unit='min'>1</timeLimit></waypoint>"),
        "updated \"1\"");
    Waypoint now = (Waypoint) goals().goals().get(0);

    assertThat(now.y()).hasValue(44.0);
    assertThat(now.timeLimit()).hasValue(60.0);
    assertThat(now.x()).isPresent();
    assertThat(now.horizontalThreshold()).isEqualTo(DEFAULT_M);
  }

  @Test
  void update_wrongGoals_areRefusedWithFileAndLine() {
    kit.start(MissionManager::new);
    refused(
        goals(MissionAction.UPDATE, "<waypoint><name>9</name><x>5</x></waypoint>"),
        "more.xml, line 2, <name>: \"9\" names no goal; the goals are 1, 2, 3");
    refused(
        goals(MissionAction.UPDATE, "<waypoint><x>5</x></waypoint>"),
        "more.xml, line 2, <waypoint>: lacks <name>; expected the name of the goal that changes");
    refused(
        goals(
            MissionAction.UPDATE,
            "<waypoint><name>1</name><verticalThreshold>9</verticalThreshold></waypoint>"),
        "more.xml, line 2, <verticalThreshold>: has nothing to compare with: the goal has no <z>");
    refused(
        goals(MissionAction.UPDATE, "<waypoint><name>1</name><next>9</next></waypoint>"),
        "more.xml, line 2, <next>: \"9\" names no goal; the goals are 1, 2, 3");
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
  void replace_now_pursuesOnlyTheNewGoals() {
    kit.start(MissionManager::new);
    complete("1");
    String goals =
        "<waypoint><name>1</name><x>5</x></waypoint><waypoint><name>b</name><x>6</x></waypoint>";
    accepted(goals(MissionAction.REPLACE, goals).now(true), "pursuing 1");
    assertThat(report().sequence()).containsExactly("1", "b");
    assertThat(report().finished()).allMatch(times -> times == 0.0);
    run("1", "b");
    assertThat(current()).isEmpty();
  }

  @Test
  void replace_notNow_beginsPaused() {
    kit.start(MissionManager::new);
    accepted(
        goals(MissionAction.REPLACE, "<waypoint><name>a</name><x>5</x></waypoint>"), "paused at a");
    assertThat(report().paused()).isTrue();
    accepted(order(MissionAction.RESUME), "resumed at [a]");
  }

  @Test
  void replace_wrong_keepsTheMission() {
    kit.start(MissionManager::new);
    refused(
        goals(MissionAction.REPLACE, "<waypoint><x>500</x></waypoint>"),
        "more.xml, line 2, <x>: 500.0 is outside -180.0…180.0 deg of longitude");
    refused(order(MissionAction.REPLACE), "no goals; expected a mission in XML");
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

  private <T extends U2SAData> T lateBy(double seconds, T message) {
    kit.advance(30.0);
    message.timestamp(kit.clock().micros() - Clock.micros(seconds));
    return message;
  }

  /** As of a program that uses one ID for all. */
  @Test
  void order_idOfAnotherOrder_isExecuted() {
    kit.start(MissionManager::new);
    kit.publish(Channels.MISSION, order(MissionAction.GOTO).uid("3").requestId("x"));
    assertThat(current()).containsExactly("3");
    kit.publish(Channels.MISSION, order(MissionAction.PAUSE).requestId("x"));
    MissionOrderResult paused = (MissionOrderResult) kit.latest(Channels.MISSION).orElseThrow();
    assertThat(paused.outcome()).isEqualTo("paused at 3");
    kit.publish(Channels.MISSION, order(MissionAction.RESUME).requestId("x"));
    kit.publish(Channels.MISSION, order(MissionAction.PAUSE).requestId("x"));
    MissionOrderResult again = (MissionOrderResult) kit.latest(Channels.MISSION).orElseThrow();
    assertThat(again.outcome()).isEqualTo("paused at 3");
  }

  @Test
  void order_sameOrderGivenAgainUnderItsId_isExecutedAndARepeatIsNot() {
    kit.start(MissionManager::new);
    MissionOrder first = order(MissionAction.GOTO).uid("2").requestId("x");
    kit.publish(Channels.MISSION, first);
    accepted(order(MissionAction.GOTO).uid("3"), "pursuing goal \"3\"");
    kit.publish(Channels.MISSION, first);
    assertThat(current()).as("arrives twice").containsExactly("3");

    kit.advance(1.0);
    kit.publish(Channels.MISSION, order(MissionAction.GOTO).uid("2").requestId("x"));
    assertThat(current()).containsExactly("2");
  }

  @Test
  void order_arrivesAgainAtARestartedManager_isAnsweredButNotExecutedAgain() {
    MissionManager before = kit.start(MissionManager::new);
    MissionOrder skip = order(MissionAction.SKIP).requestId("x");
    kit.publish(Channels.MISSION, skip);
    assertThat(current()).containsExactly("2");
    kit.restart(before, MissionManager::new);
    kit.publish(Channels.MISSION, skip);

    assertThat(current()).containsExactly("2");
    MissionOrderResult again = (MissionOrderResult) kit.latest(Channels.MISSION).orElseThrow();
    assertThat(again.outcome()).isEqualTo("goal \"1\" skipped; current: 2");
  }

  /** A broker keeps orders while a link is down. */
  @Test
  void order_olderThanItsExpiry_isRefusedUnlessItPauses() {
    kit.start(MissionManager::new);
    refused(
        lateBy(20.0, order(MissionAction.GOTO).uid("3")),
        "the order arrived 20.0 s after it was given; expected at most ORDER EXPIRY, 5 s: give it"
            + " again (if it was given just now, the clocks differ)");
    String id = "order " + orders;
    kit.publish(Channels.MISSION, lateBy(4.0, order(MissionAction.GOTO).uid("3").requestId(id)));
    assertThat(current()).as("given again under its ID").containsExactly("3");
    accepted(lateBy(20.0, order(MissionAction.PAUSE)), "paused at 3");
    MissionOrderResult resumed = give(lateBy(20.0, order(MissionAction.RESUME)));
    assertThat(resumed.accepted()).isFalse();
  }

  @Test
  void goalCommandAndUpdate_olderThanTheirExpiry_haveNoEffect() {
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_COMMANDS, lateBy(20.0, new GoalCommand().uid("3")));
    kit.publish(
        Channels.GOAL_UPDATES,
        lateBy(20.0, new Waypoint().uid("1").x(77.0).y(1.0).horizontalThreshold(1.0)));

    assertThat(current()).containsExactly("1");
    assertThat(kit.log("MissionManager"))
        .anyMatch(line -> line.contains("command to change to goal \"3\" rejected: the order"))
        .anyMatch(line -> line.contains("update of goal \"1\" refused: the order arrived 20.0 s"));
    kit.publish(Channels.GOAL_COMMANDS, lateBy(4.0, new GoalCommand().uid("3")));
    assertThat(current()).containsExactly("3");
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
