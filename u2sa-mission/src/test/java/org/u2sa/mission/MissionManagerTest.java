package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.mission.MissionRequest;

/** What a MissionManager publishes, and what it does about reports, commands and changes. */
class MissionManagerTest extends ThreeWaypoints {
  @Test
  void start_publishesTheFirstGoalAndWhatComesNext() {
    kit.with("DEFAULT THRESHOLD", 12.0).start(MissionManager::new);

    assertThat(goals().goals()).extracting(GoalInformation::uid).containsExactly("1");
    assertThat(goals().upcoming()).extracting(GoalInformation::uid).containsExactly("2");
    assertThat(((Waypoint) goals().goals().get(0)).horizontalThreshold()).isEqualTo(12.0);
  }

  @Test
  void start_wrongMission_failsBeforeAnyThreadRuns() throws IOException {
    Files.writeString(file, "<mission/>");

    assertThatThrownBy(() -> new MissionManager(kit.context()))
        .isInstanceOf(BadInputException.class)
        .hasMessageStartingWith(file + ", line 1, <mission>: contains no goals");
  }

  @Test
  void callback_completedGoal_goesOnToTheNext() {
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_REPORTS, report("1").completed(true));

    assertThat(goals().goals()).extracting(GoalInformation::uid).containsExactly("2");
    assertThat(logged("goal \"1\" completed")).isTrue();
  }

  @Test
  void callback_allFinished_emptyListSaysTheMissionIsOver() {
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_REPORTS, report("1").completed(true));
    Waypoint lost = report("2");
    lost.abandoned(true);
    kit.publish(Channels.GOAL_REPORTS, lost);
    kit.publish(Channels.GOAL_REPORTS, report("3").completed(true));

    assertThat(goals().goals()).isEmpty();
    assertThat(logged("mission is over: completed [1, 3], given up [2]")).isTrue();
  }

  @Test
  void callback_reportRepeated_isLeftOut() {
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_REPORTS, report("1").completed(true));
    kit.publish(Channels.GOAL_REPORTS, report("1").completed(true));

    assertThat(goals().goals()).extracting(GoalInformation::uid).containsExactly("2");
    assertThat(logged("report of goal \"1\" ignored: it is not current")).isTrue();
  }

  @Test
  void callback_floodOfReportsOfInventedGoals_fillsNoLog() {
    kit.start(MissionManager::new);
    for (int i = 1; i <= 1_000; i++) {
      kit.publish(Channels.GOAL_REPORTS, report("invented " + i).completed(true));
    }

    assertThat(kit.log("MissionManager").stream().filter(line -> line.contains("is not known")))
        .hasSize(100 + 3)
        .anyMatch(line -> line.contains("\"invented 512\" ignored: it is not known (512 so far)"));
    assertThat(goals().goals()).extracting(GoalInformation::uid).containsExactly("1");
  }

  @Test
  void callback_sameReportAgainInALoopOfOneGoal_countsOneLap() throws IOException {
    Files.writeString(
        file,
        "<mission><waypoint><name>a</name><x>1</x><repeat from='a' times='3'/></waypoint></mission>");
    kit.start(MissionManager::new);
    for (long micros : new long[] {100, 100, 200, 200}) {
      Waypoint done = report("a");
      done.completed(true).timestamp(micros);
      kit.publish(Channels.GOAL_REPORTS, done);
    }

    assertThat(goals().goals()).extracting(GoalInformation::uid).containsExactly("a");
    assertThat(kit.log("MissionManager").stream().filter(line -> line.contains("a\" completed")))
        .hasSize(2);
  }

  @Test
  void callback_reportOfAGoalThatIsNotCurrent_isAnsweredWithTheCurrentGoals() {
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_REPORTS, report("1").completed(true));
    kit.forget(); // as if the list of goals had never arrived

    kit.publish(Channels.GOAL_REPORTS, report("1").completed(true));

    assertThat(goals().goals()).extracting(GoalInformation::uid).containsExactly("2");
  }

  @Test
  void callback_suchReportsAllTheTime_areAnsweredOnceASecondAtMost() {
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_REPORTS, report("1").completed(true));
    kit.forget();

    for (int i = 0; i < 30; i++) {
      kit.publish(Channels.GOAL_REPORTS, report("1").completed(true));
      kit.publish(Channels.GOAL_REPORTS, report("unknown").completed(true));
      kit.advance(0.1);
    }

    assertThat(kit.published(Channels.GOALS)).hasSize(3);
  }

  @Test
  void callback_command_changesTheGoalNow() {
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_COMMANDS, new GoalCommand().uid("3"));

    assertThat(goals().goals()).extracting(GoalInformation::uid).containsExactly("3");
    assertThat(logged("changing to goal \"3\" on command")).isTrue();
  }

  @Test
  void callback_commandOfUnknownGoal_isRefused() {
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_COMMANDS, new GoalCommand().uid("home"));

    assertThat(goals().goals()).extracting(GoalInformation::uid).containsExactly("1");
    assertThat(logged("command to change to goal \"home\" rejected: unknown")).isTrue();
  }

  @Test
  void callback_commandToGoHome_homeIsAWaypointWithoutAltitude() throws IOException {
    Files.writeString(
        file,
        "<mission><home><x>8</x><y>50</y><z>3</z></home><waypoint><x>1</x></waypoint></mission>");
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_COMMANDS, new GoalCommand().uid("home"));

    assertThat(goals().goals())
        .singleElement()
        .isEqualTo(new Waypoint().uid("home").x(8.0).y(50.0).horizontalThreshold(DEFAULT_M));
    kit.publish(Channels.GOAL_REPORTS, report("home").completed(true));
    assertThat(goals().goals()).isEmpty();
  }

  @Test
  void callback_updateOfTheCurrentGoal_isPublished() {
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_UPDATES, report("1").y(44.0));

    assertThat(((Waypoint) goals().goals().get(0)).y()).hasValue(44.0);
  }

  @Test
  void callback_updateThatCannotBePursued_isRefused() {
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_UPDATES, new Landing().uid("1").x(8.0).horizontalThreshold(1.0));
    kit.publish(Channels.GOAL_UPDATES, report("1").referenceFrame(ReferenceFrame.BODY));
    kit.publish(Channels.GOAL_UPDATES, new Waypoint().uid("new").horizontalThreshold(1.0));

    assertThat(logged("update of goal \"1\" refused: it lacks x, y or z")).isTrue();
    assertThat(logged("update of goal \"1\" refused: it is in a frame that moves")).isTrue();
    assertThat(logged("update of goal \"new\" refused: it has no coordinates")).isTrue();
    assertThat(goals().goals().get(0)).isExactlyInstanceOf(Waypoint.class);
  }

  @Test
  void goalUpdate_thatSaysCompleted_isNoReport() {
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_UPDATES, report("1").completed(true));

    assertThat(goals().goals()).extracting(GoalInformation::uid).containsExactly("1");
  }

  @Test
  void goalReport_neitherCompletedNorAbandoned_changesNothing() {
    kit.start(MissionManager::new);
    int before = kit.published(Channels.GOALS).size();
    kit.publish(Channels.GOAL_REPORTS, report("1").y(44.0));

    assertThat(kit.published(Channels.GOALS)).hasSize(before);
  }

  private static final int LONGEST_MESSAGE = 1 << 20;

  private static List<String> longNames(String first) {
    List<String> names = new ArrayList<>(List.of(first));
    for (int i = 0; i < 700; i++) {
      names.add("x".repeat(990) + i);
    }
    return names;
  }

  private void assertListsAreShortAndTheMissionGoesOn() {
    assertThat(kit.published(Channels.GOALS))
        .allMatch(list -> list.serialize().length < LONGEST_MESSAGE);
    kit.publish(Channels.GOAL_REPORTS, report("1").completed(true));
    assertThat(goals().goals()).extracting(GoalInformation::uid).containsExactly("2");
  }

  @Test
  void callback_updatesThatMakeTheGoalsTooLong_areRefused() {
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_UPDATES, report("1").next(longNames("2")));
    kit.publish(Channels.GOAL_UPDATES, report("2").next(longNames("3")));

    assertThat(logged("update of goal \"1\" refused")).isTrue();
    assertListsAreShortAndTheMissionGoesOn();
  }

  @Test
  void callback_newGoalsWithoutEnd_areRefusedAtLast() {
    kit.start(MissionManager::new);
    for (int i = 0; i < 100; i++) {
      kit.publish(Channels.GOAL_UPDATES, report("new " + i).next(longNames("2").subList(0, 11)));
    }
    kit.publish(Channels.GOAL_UPDATES, report("1").y(44.0));

    assertThat(logged("goal \"new 20\" added")).isTrue();
    assertThat(logged("goal \"new 90\" added")).isFalse();
    assertThat(((Waypoint) goals().goals().get(0)).y()).as("one that is short").hasValue(44.0);
    kit.publish(Channels.MISSION, new MissionRequest().requestId("r"));
    MissionReport all = (MissionReport) kit.latest(Channels.MISSION).orElseThrow();
    assertThat(all.serialize().length).isLessThan(LONGEST_MESSAGE);
    assertListsAreShortAndTheMissionGoesOn();
  }

  @Test
  void goalReport_tooLong_completesTheGoalWithoutItsFields() {
    kit.start(MissionManager::new);
    for (String uid : List.of("1", "2", "3")) {
      Waypoint done = report(uid);
      done.completed(true).next(longNames("2")).reason("x".repeat(65_000));
      kit.publish(Channels.GOAL_REPORTS, done);
    }
    assertThat(logged("mission is over: completed [1, 2, 3]")).isTrue();
    kit.publish(Channels.MISSION, new MissionRequest().requestId("r"));
    MissionReport all = (MissionReport) kit.latest(Channels.MISSION).orElseThrow();
    assertThat(all.serialize().length).isLessThan(LONGEST_MESSAGE);
  }

  @Test
  void callback_newGoal_isAddedWithAWarning() {
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_UPDATES, report("4"));

    assertThat(logged("goal \"4\" added; it is not pursued until another goal's next names it"))
        .isTrue();
    kit.publish(Channels.GOAL_COMMANDS, new GoalCommand().uid("4"));
    assertThat(goals().goals()).extracting(GoalInformation::uid).containsExactly("4");
  }

  private void change(String variable, String value) {
    kit.publish(
        Channels.CONFIGURATION,
        new ConfigurationChange()
            .serviceName("MissionManager")
            .variableName(variable)
            .value(value));
  }

  @Test
  void configurationChange_ofTheMission_beginsTheNewOne() throws IOException {
    kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_REPORTS, report("1").completed(true));
    Path other = directory.resolve("other.xml");
    Files.writeString(other, "<mission><waypoint><name>dock</name><x>1</x></waypoint></mission>");
    change("MISSION", other.toString());

    assertThat(goals().goals()).extracting(GoalInformation::uid).containsExactly("dock");
  }

  @Test
  void configurationChange_toAWrongMission_isRefusedAndTheOneBeforeGoesOn() {
    MissionManager manager = kit.start(MissionManager::new);
    kit.publish(Channels.GOAL_REPORTS, report("1").completed(true));
    change("MISSION", "no/such.xml");

    assertThat(goals().goals()).extracting(GoalInformation::uid).containsExactly("2");
    assertThat(logged("no/such.xml: there is no such file")).isTrue();
    assertThat(manager.getVariable("MISSION")).isEqualTo(file.toString());
  }

  @Test
  void configurationChange_ofLoop_countsFromNowOn() {
    kit.start(MissionManager::new);
    change("LOOP", "true");
    for (String uid : new String[] {"1", "2", "3"}) {
      kit.publish(Channels.GOAL_REPORTS, report(uid).completed(true));
    }

    assertThat(goals().goals()).extracting(GoalInformation::uid).containsExactly("1");
  }
}
