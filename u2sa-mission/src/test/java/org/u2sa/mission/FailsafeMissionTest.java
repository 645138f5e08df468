package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.testkit.ServiceKit;

/** What the Mission Manager does when a failsafe says so. */
@Timeout(120)
class FailsafeMissionTest {
  private static final String MISSION =
      """
      <mission>%s
        <waypoint><name>1</name><next>2</next><x>1</x><y>1</y></waypoint>
        <waypoint><name>2</name><x>1</x><y>2</y></waypoint>
      </mission>
      """;
  private static final String HOME = "<home><x>0.5</x><y>0.5</y></home>";

  @TempDir private Path directory;
  private final ServiceKit kit = new ServiceKit();

  @BeforeEach
  void configure() throws IOException {
    kit.with("MISSION", write("mission.xml", HOME)).with("DEFAULT THRESHOLD", 1.0);
  }

  @AfterEach
  void close() {
    kit.close();
  }

  private String write(String name, String home) throws IOException {
    return Files.writeString(directory.resolve(name), MISSION.formatted(home)).toString();
  }

  private void failsafe(FailsafeAction action) {
    kit.publish(Channels.FAILSAFE, new FailsafeState().action(action).causes(List.of("a test")));
  }

  private List<String> goals() {
    return kit.latest(Channels.GOALS).orElseThrow().goals().stream()
        .map(GoalInformation::uid)
        .collect(Collectors.toList());
  }

  @Test
  void failsafe_keptFromAnEarlierRun_isIgnoredUntilOneIsHeardInThisRun() {
    failsafe(FailsafeAction.RETURN);
    kit.advance(6.0);
    kit.start(MissionManager::new);
    assertThat(goals()).containsExactly("1");

    FailsafeState behind =
        new FailsafeState().action(FailsafeAction.RETURN).causes(List.of("late"));
    behind.timestamp(0); // of a Safety Manager whose clock is behind
    kit.publish(Channels.FAILSAFE, (FailsafeState) behind.copy());
    assertThat(goals()).as("the same again").containsExactly("1");
    behind.timestamp(1_000_000);
    kit.publish(Channels.FAILSAFE, behind);

    assertThat(goals()).doesNotContain("1");
  }

  private void complete(String uid) {
    Waypoint report = new Waypoint().uid(uid).horizontalThreshold(1.0);
    report.completed(true);
    kit.publish(Channels.GOAL_REPORTS, report);
  }

  /** As after a restart: the failsafe, which is retained, comes before the first state. */
  @Test
  void return_beforeAPositionIsKnown_waitsForItWhereTheFenceHasAreas() {
    kit.start(MissionManager::new);
    Polygon wall =
        new Polygon()
            .points(
                List.of(
                    Point.of(0.4995, 0.5008, 0.0),
                    Point.of(0.5005, 0.5008, 0.0),
                    Point.of(0.5005, 0.5012, 0.0),
                    Point.of(0.4995, 0.5012, 0.0)));
    wall.uid("wall").referenceFrame(ReferenceFrame.GLOBAL).x(0.4995).y(0.5008);
    kit.publish(Channels.FENCE, new FenceState().file("f.xml").keepOut(List.of(wall)));
    failsafe(FailsafeAction.RETURN);
    assertThat(goals()).noneMatch(name -> name.startsWith("RETURN"));

    StateInformation state = new StateInformation().sensorName("StateEstimator").x(0.5).y(0.502);
    state.timestamp(kit.clock().micros());
    kit.publish(Channels.STATE, state);
    failsafe(FailsafeAction.RETURN); // it is repeated
    assertThat(goals().get(0)).startsWith("RETURN way");

    failsafe(FailsafeAction.CONTINUE);
    failsafe(FailsafeAction.RETURN);
    assertThat(goals().get(0)).startsWith("RETURN way");
  }

  @Test
  void return_positionNeverKnown_isPursuedAfterThreeRepetitions() {
    kit.start(MissionManager::new);
    Polygon wall =
        new Polygon()
            .points(List.of(Point.ORIGIN, Point.of(1.0, 0.0, 0.0), Point.of(0.0, 1.0, 0.0)));
    wall.uid("wall").referenceFrame(ReferenceFrame.GLOBAL).x(0.0).y(0.0);
    kit.publish(Channels.FENCE, new FenceState().file("f.xml").keepOut(List.of(wall)));
    for (int i = 0; i < 3; i++) {
      failsafe(FailsafeAction.RETURN);
      assertThat(goals()).containsExactly("1");
    }
    failsafe(FailsafeAction.RETURN);
    assertThat(goals()).doesNotContain("1");
  }

  @Test
  void return_withoutFile_goesHomeAndResumesWhereTheMissionWas() {
    kit.start(MissionManager::new);
    complete("1");
    failsafe(FailsafeAction.RETURN);
    Waypoint home = (Waypoint) kit.latest(Channels.GOALS).orElseThrow().goals().get(0);
    assertThat(home.uid()).isEqualTo("RETURN home");
    assertThat(kit.published(Channels.GOALS)).extracting(GoalList::returning).contains(false);
    assertThat(kit.latest(Channels.GOALS).orElseThrow().returning()).isTrue();
    assertThat(home.x()).hasValue(0.5);
    complete("RETURN home");
    assertThat(goals()).isEmpty();

    failsafe(FailsafeAction.CONTINUE);

    assertThat(goals()).containsExactly("2");
  }

  @Test
  void returnAndLand_withFiles_areFlownUnderNamesOfTheirOwn() throws IOException {
    kit.with("RETURN MISSION", write("return.xml", "")).with("LAND MISSION", write("land.xml", ""));
    kit.start(MissionManager::new);
    failsafe(FailsafeAction.RETURN);
    complete("RETURN 1");
    assertThat(goals()).containsExactly("RETURN 2");

    failsafe(FailsafeAction.LAND);
    assertThat(goals()).containsExactly("LAND 1");
    failsafe(FailsafeAction.CONTINUE);

    assertThat(goals()).containsExactly("1");
  }

  @ParameterizedTest
  @EnumSource(names = {"RETURN", "LAND"})
  void returnAndLand_withALandingStart_beginThere(FailsafeAction action) throws IOException {
    String mission =
        """
        <mission><home><x>0.5</x><y>0.5</y></home>
          <waypoint><name>1</name><x>1</x><y>1</y></waypoint>
          <waypoint><name>down</name><landingStart>true</landingStart><x>1</x><y>2</y></waypoint>
          <landing><name>runway</name><x>1</x><y>3</y><z>0</z></landing>
        </mission>
        """;
    kit.with("MISSION", Files.writeString(directory.resolve("m.xml"), mission).toString());
    kit.start(MissionManager::new);
    assertThat(kit.latest(Channels.GOALS).orElseThrow().landGoals()).hasValue(2);
    failsafe(action);
    assertThat(goals()).containsExactly(action + " down");
    complete(action + " down");
    assertThat(goals()).containsExactly(action + " runway");
    failsafe(FailsafeAction.CONTINUE);

    assertThat(goals()).containsExactly("1");
  }

  @Test
  void land_goalsWithTheLongestNames_arePursuedInTheirOrder() throws IOException {
    String first = "a".repeat(1_000);
    String second = "b".repeat(1_000);
    String mission =
        "<mission><waypoint><name>"
            + first
            + "</name><next>"
            + second
            + "</next><landingStart>true</landingStart><x>1</x><y>2</y></waypoint><waypoint><name>"
            + second
            + "</name><x>1</x><y>3</y></waypoint></mission>";
    kit.with("MISSION", Files.writeString(directory.resolve("m.xml"), mission).toString());
    kit.start(MissionManager::new);
    failsafe(FailsafeAction.LAND);
    assertThat(goals()).hasSize(1);
    complete(goals().get(0));

    assertThat(goals()).containsExactly("LAND " + Integer.toHexString(second.hashCode()));
  }

  @Test
  void hold_leavesTheGoalsAlone() {
    kit.start(MissionManager::new);
    kit.forget();
    failsafe(FailsafeAction.HOLD);
    failsafe(FailsafeAction.CONTINUE);

    assertThat(kit.published(Channels.GOALS)).isEmpty();
  }

  @Test
  void return_withoutFileAndHome_hasNoGoalsAndSaysSo() throws IOException {
    kit.with("MISSION", write("homeless.xml", ""));
    kit.start(MissionManager::new);
    failsafe(FailsafeAction.LAND);

    assertThat(goals()).isEmpty();
    assertThat(kit.log("MissionManager"))
        .anyMatch(line -> line.contains("without a LAND MISSION: returning"))
        .anyMatch(line -> line.contains("without a RETURN MISSION or a home: holding"));
  }

  @Test
  void start_wrongReturnMission_failsBeforeAnyThreadRuns() throws IOException {
    kit.with(
        "RETURN MISSION", Files.writeString(directory.resolve("r.xml"), "<mission/>").toString());

    assertThatThrownBy(() -> new MissionManager(kit.context()))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("r.xml, line 1, <mission>: contains no goals");
  }

  @Test
  void restart_whileItReturns_stillReturnsAndResumesTheMissionAfterwards() {
    MissionManager before = kit.start(MissionManager::new);
    complete("1");
    failsafe(FailsafeAction.RETURN);
    kit.forget();

    kit.restart(before, MissionManager::new);

    assertThat(goals()).containsExactly("RETURN home");
    failsafe(FailsafeAction.RETURN);
    complete("RETURN home");
    assertThat(goals()).isEmpty();
    failsafe(FailsafeAction.CONTINUE);
    assertThat(goals()).containsExactly("2");
  }

  @Test
  void load_fileThatHasBecomeWrong_keepsItsGoalsAndItsHome() throws IOException {
    Path file = Path.of(write("land.xml", HOME));
    kit.with("LAND MISSION", file.toString());
    AtomicReference<FailsafeMissions> missions = new AtomicReference<>();
    kit.start(
        context -> {
          MissionManager manager = new MissionManager(context);
          missions.set(
              new FailsafeMissions(
                  new MissionRun(context.clock(), () -> 1.0),
                  new MissionFiles(context),
                  context.configuration().settings(MissionVariables.class)::get,
                  manager));
          return manager;
        });
    Files.writeString(file, "<mission><waypoint/></mission>");

    assertThatThrownBy(() -> missions.get().load()).isInstanceOf(BadInputException.class);

    GoalSequence landing =
        missions
            .get()
            .sequence(FailsafeAction.LAND, Optional.empty(), place -> Optional.of(List.of()))
            .orElseThrow();
    assertThat(landing.currentNames()).containsExactly("LAND 1");
    assertThat(landing.knows("LAND home")).isTrue();
  }

  private void update(String uid, double x) {
    kit.publish(
        Channels.GOAL_UPDATES, new Waypoint().uid(uid).x(x).y(2.0).horizontalThreshold(1.0));
  }

  private double x(int goal) {
    GoalInformation current = kit.latest(Channels.GOALS).orElseThrow().goals().get(goal);
    return ((Waypoint) current).x().orElseThrow();
  }

  @Test
  void updateOfAMissionGoalDuringReturn_countsWhenTheMissionResumes() {
    kit.start(MissionManager::new);
    failsafe(FailsafeAction.RETURN);
    update("1", 3.0);
    failsafe(FailsafeAction.CONTINUE);

    assertThat(goals()).containsExactly("1");
    assertThat(x(0)).isEqualTo(3.0);
  }

  @Test
  void updateOfANewGoalDuringReturn_isKnownToTheMission() {
    kit.start(MissionManager::new);
    failsafe(FailsafeAction.RETURN);
    update("gate", 3.0);
    failsafe(FailsafeAction.CONTINUE);
    kit.publish(Channels.GOAL_COMMANDS, new GoalCommand().uid("gate"));

    assertThat(goals()).containsExactly("gate");
  }

  @Test
  void updateOfAFailsafeGoalDuringReturn_countsAtOnce() {
    kit.start(MissionManager::new);
    failsafe(FailsafeAction.RETURN);
    update("RETURN home", 3.0);

    assertThat(goals()).containsExactly("RETURN home");
    assertThat(x(0)).isEqualTo(3.0);
  }
}
