package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionAction;

/** Goals that operators insert into a running mission, change and replace. */
class InsertedGoalsTest extends OrderedMission {

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
}
