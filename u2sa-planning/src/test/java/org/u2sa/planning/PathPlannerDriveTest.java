package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.guidance.Leg;

class PathPlannerDriveTest {
  private static final Map<String, Object> AIRCRAFT =
      Map.of(
          "LOOK AHEAD", 150.0,
          "LOOK AHEAD TIME", 5.0,
          "TURN ACCELERATION", 4.57,
          "TURN LAG", 1.0,
          "AT END", "HOLD",
          "LOITER RADIUS", 800.0);

  /** A zigzag with turns of 90, 135 and 45 degrees to both sides. */
  private static final double[][] CORNERS = {
    {3000, 0, 300}, {3000, 3000, 300}, {5000, 1000, 450}, {8000, 1000, 450}, {8000, 4000, 300}
  };

  @TempDir private Path directory;

  @Test
  void aircraft_zigzag_capturesAllNearAndStaysOnTheStraights() throws IOException {
    try (TestDrive drive =
        new TestDrive(new TestAircraft(0, 0, 300, 0), airMission(""), AIRCRAFT)) {
      assertThat(drive.until(drive::isMissionOver, 600.0)).isTrue();

      assertThat(drive.reports())
          .extracting(GoalInformation::uid)
          .containsExactly("1", "2", "3", "4", "5");
      assertThat(drive.reports()).allMatch(GoalInformation::completed);
      for (double[] corner : CORNERS) {
        assertThat(drive.missM(corner[0], corner[1])).as("at %s", corner).isLessThan(75.0);
      }
      assertThat(crossTrackRmsM(drive, 1500.0)).isLessThan(5.0);
    }
  }

  @Test
  void aircraft_withoutAnticipation_overshootsMore() throws IOException {
    Map<String, Object> late = new HashMap<>(AIRCRAFT);
    late.put("CORNER LIMIT", 0.0);
    try (TestDrive early = new TestDrive(new TestAircraft(0, 0, 300, 0), airMission(""), AIRCRAFT);
        TestDrive drive = new TestDrive(new TestAircraft(0, 0, 300, 0), airMission(""), late)) {
      early.until(early::isMissionOver, 600.0);
      drive.until(drive::isMissionOver, 600.0);

      assertThat(overshootM(early)).isBetween(0.0, 0.6 * overshootM(drive));
    }
  }

  @Test
  void aircraft_cannotClimbInTime_circlesBackUntilHighEnough() throws IOException {
    try (TestDrive drive =
        new TestDrive(
            new TestAircraft(0, 0, 0, 0),
            airMission("<verticalThreshold>20</verticalThreshold>"),
            AIRCRAFT)) {
      assertThat(drive.until(() -> !drive.reports().isEmpty(), 600.0)).isTrue();

      assertThat(drive.reports().get(0).completed()).isTrue();
      assertThat(drive.track.get(drive.track.size() - 1).altitude()).isGreaterThan(279.0);
      assertThat(drive.kit.log("PathPlanner"))
          .anyMatch(
              line ->
                  line.contains("goal \"1\" missed")
                      && line.contains("attempt 1 of 3: turning round"));
    }
  }

  @Test
  void aircraft_waypointNeverReached_isGivenUpAndTheNextOneFlown() throws IOException {
    Map<String, Object> once = new HashMap<>(AIRCRAFT);
    once.put("ATTEMPTS", 1);
    try (TestDrive drive =
        new TestDrive(
            new TestAircraft(0, 0, 0, 0),
            airMission("<verticalThreshold>5</verticalThreshold>"),
            once)) {
      assertThat(drive.until(() -> !drive.reports().isEmpty(), 300.0)).isTrue();

      GoalInformation report = drive.reports().get(0);
      assertThat(report.abandoned()).isTrue();
      assertThat(report.completed()).isFalse();
      assertThat(drive.kit.log("MissionManager"))
          .anyMatch(line -> line.contains("goal \"1\" abandoned"));
      assertThat(drive.kit.log("MissionManager"))
          .anyMatch(line -> line.contains("current goals [2]"));
    }
  }

  @Test
  void aircraft_waypointBehindAndInsideItsTurningCircle_isReached() throws IOException {
    String mission = mission(waypoint(-150, 250, 300, 50, ""));
    try (TestDrive drive = new TestDrive(new TestAircraft(0, 0, 300, 0), mission, AIRCRAFT)) {
      assertThat(drive.until(drive::isMissionOver, 300.0)).isTrue();

      assertThat(drive.missM(-150, 250)).isLessThan(50.0);
      assertThat(drive.reports()).allMatch(GoalInformation::completed);
    }
  }

  @Test
  void aircraft_afterLastWaypoint_holdsOnTheCircle() throws IOException {
    String mission = mission(waypoint(2000, 0, 300, 50, ""));
    try (TestDrive drive = new TestDrive(new TestAircraft(0, 0, 300, 0), mission, AIRCRAFT)) {
      assertThat(drive.until(drive::isMissionOver, 100.0)).isTrue();
      drive.until(() -> false, 200.0);
      drive.track.clear();
      drive.until(() -> false, 150.0);

      assertThat(drive.track)
          .allSatisfy(
              s -> assertThat(Math.hypot(s.north() - 2000.0, s.east())).isBetween(760.0, 840.0));
    }
  }

  @Test
  void aircraft_directGuidance_reachesWaypointsToo() throws IOException {
    Map<String, Object> direct = Map.of("GUIDANCE", "DIRECT");
    try (TestDrive drive =
        new TestDrive(new DirectAircraft(), mission(waypoint(4000, 2000, 400, 100, "")), direct)) {
      assertThat(drive.until(drive::isMissionOver, 200.0)).isTrue();
    }
  }

  @Test
  void rover_squareOnLocalPlane_capturesAllAndStaysOnTheLines() throws IOException {
    double[][] square = {{20, 0}, {20, 20}, {0, 20}, {0, 0}};
    StringBuilder goals = new StringBuilder();
    for (double[] corner : square) {
      goals.append(
          String.format(
              Locale.ROOT,
              "<waypoint><reference>Local NED</reference><x>%s</x><y>%s</y><horizontalThreshold>0.5</horizontalThreshold></waypoint>",
              corner[0],
              corner[1]));
    }
    try (TestDrive drive =
        new TestDrive(
            new TestRover(0.0, 0.0, Math.PI),
            mission(goals.toString()),
            Map.of("LOOK AHEAD", 0.8))) {
      assertThat(drive.until(drive::isMissionOver, 300.0)).isTrue();

      assertThat(drive.reports()).hasSize(4).allMatch(GoalInformation::completed);
      for (double[] corner : square) {
        assertThat(drive.missM(corner[0], corner[1])).isLessThanOrEqualTo(0.5);
      }
      double worst =
          drive.track.stream()
              .mapToDouble(
                  s ->
                      Math.min(
                          Math.min(Math.abs(s.north()), Math.abs(s.north() - 20.0)),
                          Math.min(Math.abs(s.east()), Math.abs(s.east() - 20.0))))
              .max()
              .orElseThrow();
      assertThat(worst).isLessThan(0.5);
      drive.track.clear();
      drive.until(() -> false, 5.0);
      assertThat(drive.missM(0.0, 0.0))
          .isGreaterThan(0.3); // AT END is STOP: it stays where it reached the last
    }
  }

  /** Flies unit vectors as the thesis's controllers do: proportionally. */
  private static final class DirectAircraft extends TestVehicle {
    DirectAircraft() {
      altitude = 300.0;
      speed = 46.0;
    }

    @Override
    void step(double dtS, Optional<NavigationPoint> point) {
      if (point.isPresent()) {
        Point unit = point.get().point();
        assertThat(Math.hypot(unit.x(), unit.y())).isBetween(0.999, 1.001);
        assertThat(unit.z()).isBetween(-1.0, 1.0);
        heading += Math.max(-0.1, Math.min(0.1, -unit.azimuth())) * dtS;
        altitude -= 5.0 * unit.z() * dtS;
      }
      move(dtS);
    }
  }

  /** RMS distance from the legs where they are farther than the margin from their ends. */
  private static double crossTrackRmsM(TestDrive drive, double margin) {
    double sum = 0.0;
    int count = 0;
    for (TestDrive.Sample s : drive.track) {
      if (s.goalsDone() >= 1 && s.goalsDone() < CORNERS.length) {
        double[] from = CORNERS[s.goalsDone() - 1];
        double[] to = CORNERS[s.goalsDone()];
        Leg leg = new Leg(from[0], from[1], to[0], to[1]);
        double along = leg.alongM(s.north(), s.east());
        if (along > margin && along < leg.lengthM() - 300.0) {
          sum += Math.pow(leg.acrossM(s.north(), s.east()), 2);
          count++;
        }
      }
    }
    assertThat(count).isGreaterThan(500);
    return Math.sqrt(sum / count);
  }

  /** How far the aircraft swung out behind the first waypoint. */
  private static double overshootM(TestDrive drive) {
    Leg leg = new Leg(CORNERS[0][0], CORNERS[0][1], CORNERS[1][0], CORNERS[1][1]);
    return drive.track.stream()
        .filter(s -> s.goalsDone() == 1)
        .mapToDouble(s -> -leg.acrossM(s.north(), s.east()))
        .max()
        .orElseThrow();
  }

  private String airMission(String more) throws IOException {
    StringBuilder goals = new StringBuilder();
    for (double[] corner : CORNERS) {
      goals.append(waypoint(corner[0], corner[1], corner[2], 100, more));
    }
    return mission(goals.toString());
  }

  private static String waypoint(
      double north, double east, double altitude, double threshold, String more) {
    Geodetic place = TestVehicle.ORIGIN.fromNed(Point.of(north, east, 0.0));
    return String.format(
        Locale.ROOT,
        "<waypoint><x>%.9f</x><y>%.9f</y><z>%s</z><horizontalThreshold>%s</horizontalThreshold>%s</waypoint>%n",
        place.longitudeDeg(),
        place.latitudeDeg(),
        altitude,
        threshold,
        more);
  }

  private String mission(String goals) throws IOException {
    Path file = directory.resolve("mission.xml");
    Files.writeString(file, "<mission>" + goals + "</mission>");
    return file.toString();
  }
}
