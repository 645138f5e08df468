package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;

/** An attempt at a waypoint counts when the vehicle has been there, not while it turns round. */
class AttemptsTest {
  private static final double NORTH_M = 3000.0; // of the waypoint that is missed
  private static final double AT_IT_M = 200.0; // corner cut and the way until a miss is noticed

  @TempDir private Path directory;

  private TestDrive drive(
      Function<ServiceContext, U2SAService> planner, int attempts, String mission)
      throws IOException {
    Path file = directory.resolve("mission.xml");
    Files.writeString(file, "<mission>" + mission + "</mission>");
    return new TestDrive(
        new TestAircraft(0, 0, 300, 0),
        Map.of("MISSION", file.toString()),
        Map.of(
            "LOOK AHEAD", 150.0,
            "LOOK AHEAD TIME", 5.0,
            "TURN ACCELERATION", 4.57,
            "TURN LAG", 1.0,
            "ATTEMPTS", attempts),
        planner);
  }

  private static Function<ServiceContext, U2SAService> planner(String name) {
    return name.equals("lines") ? PathPlanner::new : VectorFieldPlanner::new;
  }

  /** The second waypoint lies so far from the first, after such a turn. */
  private static String two(String first, double turnDeg, double legM) {
    double turn = Math.toRadians(turnDeg);
    return waypoint(NORTH_M, 0.0, first)
        + waypoint(
            NORTH_M + legM * Math.cos(turn),
            legM * Math.sin(turn),
            "<z>300</z><horizontalThreshold>100</horizontalThreshold>");
  }

  private static String waypoint(double north, double east, String fields) {
    Geodetic place = TestVehicle.ORIGIN.fromNed(Point.of(north, east, 0.0));
    return String.format(
        Locale.ROOT,
        "<waypoint><x>%.9f</x><y>%.9f</y>%s</waypoint>",
        place.longitudeDeg(),
        place.latitudeDeg(),
        fields);
  }

  private static long misses(TestDrive drive) {
    return drive.kit.log("PathPlanner").stream()
        .filter(line -> line.contains("goal \"1\" missed"))
        .count();
  }

  @ParameterizedTest(name = "{0}, {1} attempts, turn {2} deg, next {3} m away")
  @CsvSource({
    "lines, 1, 90, 3000",
    "lines, 2, 90, 3000",
    "lines, 3, 90, 3000",
    "lines, 5, -90, 3000",
    "lines, 3, 30, 3000",
    "lines, 3, 0, 3000",
    "lines, 3, 135, 3000",
    "lines, 4, -180, 3000",
    "lines, 3, 120, 600",
    "lines, 2, -60, 400",
    "field, 2, 90, 3000",
    "field, 3, -135, 3000",
    "field, 3, 30, 600"
  })
  void towards_waypointThatCannotBeMet_isPassedAtEachAttempt(
      String guidance, int attempts, double turnDeg, double legM) throws IOException {
    String never =
        "<z>9000</z><verticalThreshold>5</verticalThreshold><horizontalThreshold>100</horizontalThreshold>";
    try (TestDrive drive = drive(planner(guidance), attempts, two(never, turnDeg, legM))) {
      List<Double> distances = new ArrayList<>();
      List<Double> times = new ArrayList<>();
      for (int attempt = 1; attempt <= attempts; attempt++) {
        int count = attempt;
        assertThat(drive.until(() -> misses(drive) == count, 300.0)).isTrue();
        TestDrive.Sample at = drive.track.get(drive.track.size() - 1);
        distances.add(Math.hypot(at.north() - NORTH_M, at.east()));
        times.add(drive.kit.nowS());
      }

      assertThat(distances).allSatisfy(far -> assertThat(far).isLessThan(AT_IT_M));
      for (int i = 1; i < times.size(); i++) {
        assertThat(times.get(i) - times.get(i - 1)).isGreaterThan(20.0); // a circle takes 60 s
      }
      assertThat(drive.reports()).extracting(GoalInformation::abandoned).containsExactly(true);
    }
  }

  @ParameterizedTest(name = "{0}, next after {1} deg")
  @CsvSource({"lines, 90", "lines, -45", "lines, 160", "field, 90"})
  void towards_tooLowAtTheFirstPass_isReachedAtTheSecondAndLastOne(String guidance, double turnDeg)
      throws IOException {
    String high =
        "<z>570</z><verticalThreshold>20</verticalThreshold><horizontalThreshold>100</horizontalThreshold>";
    try (TestDrive drive = drive(planner(guidance), 2, two(high, turnDeg, 3000.0))) {
      assertThat(drive.until(() -> !drive.reports().isEmpty(), 400.0)).isTrue();

      assertThat(misses(drive)).isEqualTo(1);
      assertThat(drive.reports()).extracting(GoalInformation::completed).containsExactly(true);
    }
  }

  /** A wide threshold must not cut the second way short either. */
  @ParameterizedTest(name = "{0}")
  @CsvSource({"lines", "field"})
  void towards_secondAttempt_isReportedWhereItComesNoNearer(String guidance) throws IOException {
    String wide =
        "<z>570</z><verticalThreshold>20</verticalThreshold><horizontalThreshold>400</horizontalThreshold>";
    try (TestDrive drive = drive(planner(guidance), 3, two(wide, 0.0, 3000.0))) {
      assertThat(drive.until(() -> misses(drive) == 1, 400.0)).isTrue();
      drive.until(() -> drive.track.get(drive.track.size() - 1).north() < NORTH_M - 500.0, 60.0);
      assertThat(drive.until(() -> !drive.reports().isEmpty(), 400.0)).isTrue();

      TestDrive.Sample at = drive.track.get(drive.track.size() - 1);
      assertThat(Math.hypot(at.north() - NORTH_M, at.east())).isLessThan(100.0);
    }
  }
}
