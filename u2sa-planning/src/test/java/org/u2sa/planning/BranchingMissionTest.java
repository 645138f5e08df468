package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.mission.MissionRequest;

/**
 * A flight with loop, time limit, branch on failure, insertion, change and restart, in lockstep.
 */
class BranchingMissionTest {
  private static final Map<String, Object> AIRCRAFT =
      Map.of(
          "LOOK AHEAD", 150.0,
          "LOOK AHEAD TIME", 5.0,
          "TURN ACCELERATION", 4.57,
          "TURN LAG", 1.0,
          "AT END", "HOLD",
          "ATTEMPTS", 1,
          "LOITER RADIUS", 800.0);

  @TempDir private Path directory;

  private static String waypoint(String name, double north, double east, String more) {
    Geodetic place = TestVehicle.ORIGIN.fromNed(Point.of(north, east, 0.0));
    return String.format(
        Locale.ROOT,
        "<waypoint><name>%s</name><x>%.9f</x><y>%.9f</y>%s</waypoint>%n",
        name,
        place.longitudeDeg(),
        place.latitudeDeg(),
        more);
  }

  private static final String MISSION =
      waypoint("start", 2000, 0, "")
          + waypoint("turn", 4000, 1500, "<repeat from='start' times='1'/>")
          + waypoint("far", 60_000, 0, "<timeLimit>30</timeLimit><next if='timed out'>low</next>")
          + waypoint("never", 0, 9000, "")
          + waypoint(
              "low",
              3000,
              4000,
              "<z>2000</z><verticalThreshold>5</verticalThreshold><next if='failed'>safe</next>")
          + waypoint("wrong", 0, 9000, "")
          + waypoint("safe", 0, 4000, "")
          + waypoint("dock", 0, 0, "");

  private TestDrive drive() throws IOException {
    Path file = directory.resolve("mission.xml");
    Files.writeString(file, "<mission>" + MISSION + "</mission>");
    return new TestDrive(new TestAircraft(0, 0, 300, 0), file.toString(), AIRCRAFT);
  }

  private static void order(TestDrive drive, MissionAction action, String goals) {
    drive.kit.publish(
        Channels.MISSION,
        new MissionOrder()
            .requestId(action + " at " + drive.kit.nowS())
            .action(action)
            .operator("anna")
            .goals("<mission>" + goals + "</mission>"));
    MissionOrderResult result =
        (MissionOrderResult) drive.kit.latest(Channels.MISSION).orElseThrow();
    assertThat(result.accepted()).as(result.outcome()).isTrue();
  }

  private static MissionReport report(TestDrive drive) {
    drive.kit.publish(Channels.MISSION, new MissionRequest().requestId("r"));
    return (MissionReport) drive.kit.latest(Channels.MISSION).orElseThrow();
  }

  private static String current(TestDrive drive) {
    List<GoalInformation> goals = drive.kit.latest(Channels.GOALS).orElseThrow().goals();
    return goals.isEmpty() ? "" : goals.get(0).uid();
  }

  private static boolean until(TestDrive drive, String uid) {
    return drive.until(() -> current(drive).equals(uid), 600.0);
  }

  @Test
  void flight_allOfIt_isFlownInTheOrderThatTheResultsSay() throws IOException {
    try (TestDrive drive = drive()) {
      assertThat(until(drive, "far")).isTrue();
      double at = drive.kit.nowS();
      assertThat(until(drive, "low")).isTrue();
      assertThat(drive.kit.nowS() - at).isBetween(29.9, 30.3);
      assertThat(until(drive, "safe")).isTrue();
      drive.restartManager();
      assertThat(current(drive)).isEqualTo("safe");
      order(drive, MissionAction.INSERT, waypoint("extra", -1500, 2000, ""));
      assertThat(drive.until(drive::isMissionOver, 600.0)).isTrue();

      assertThat(drive.reports())
          .extracting(GoalInformation::uid)
          .containsExactly("start", "turn", "start", "turn", "low", "safe", "extra", "dock");
      GoalInformation low = drive.reports().get(4);
      assertThat(low.abandoned()).isTrue();
      assertThat(low.reason().orElseThrow()).startsWith("missed, passed at ");
      assertThat(drive.missM(-1500, 2000)).isLessThan(100.0);
      assertResults(report(drive));
    }
  }

  private static void assertResults(MissionReport report) {
    assertThat(report.goals())
        .extracting(goal -> goal.uid() + " " + goal.result().map(GoalResult::name).orElse("-"))
        .containsExactly(
            "start DONE",
            "turn DONE",
            "far TIMED_OUT",
            "never -",
            "low FAILED",
            "wrong -",
            "safe DONE",
            "dock DONE",
            "extra DONE");
    assertThat(report.finished()).containsExactly(2.0, 2.0, 1.0, 0.0, 1.0, 0.0, 1.0, 1.0, 1.0);
    long last = 0;
    for (int i : new int[] {0, 1, 6, 8, 7}) {
      long arrived = report.goals().get(i).arrivedAt().orElseThrow();
      assertThat(arrived).isGreaterThan(last);
      last = arrived;
    }
  }

  @Test
  void flight_pursuedGoalIsMoved_theVehicleGoesToItsNewPlace() throws IOException {
    try (TestDrive drive = drive()) {
      drive.until(() -> false, 10.0);
      order(drive, MissionAction.UPDATE, waypoint("start", 1500, 2500, ""));
      assertThat(until(drive, "turn")).isTrue();

      assertThat(drive.missM(1500, 2500)).isLessThan(100.0);
      assertThat(drive.missM(2000, 0)).isGreaterThan(500.0);
    }
  }

  @Test
  void flight_twice_isTheSameToTheBit() throws IOException {
    try (TestDrive one = drive();
        TestDrive other = drive()) {
      until(one, "safe");
      until(other, "safe");

      assertThat(one.track).isEqualTo(other.track);
    }
  }
}
