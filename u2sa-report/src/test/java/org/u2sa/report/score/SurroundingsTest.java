package org.u2sa.report.score;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.UtmGrid;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.report.summary.RunReport;

/** What stands and moves around a run, by truth. */
class SurroundingsTest {
  private static final Geodetic ORIGIN = new Geodetic(8.0, 50.0, 0.0);

  @TempDir private Path directory;

  private static ObjectDescription tower(String uid, double eastM, double northM, double radiusM) {
    Geodetic at = ORIGIN.fromEnu(Point.of(eastM, northM, 0.0));
    return new Cylinder()
        .radius(radiusM)
        .height(2000.0)
        .uid(uid)
        .x(at.longitudeDeg())
        .y(at.latitudeDeg())
        .z(0.0);
  }

  /** Starts 20 km north of the origin at 500 m, and goes south. */
  private static MovingSphere southbound(double eastM, double speedMps) {
    Geodetic at = ORIGIN.fromEnu(Point.of(eastM, 20_000.0, 0.0));
    MovingSphere sphere = new MovingSphere().radius(100.0);
    sphere.uid("N1").x(at.longitudeDeg()).y(at.latitudeDeg()).z(500.0);
    sphere.motion().velocity(Point.of(0.0, -speedMps, 0.0));
    return sphere;
  }

  /** North from the origin at 50 m/s and 500 m. */
  private static Track north(double seconds) {
    Track track = new Track();
    for (double s = 0.0; s <= seconds; s += 0.5) {
      Geodetic at = ORIGIN.fromEnu(Point.of(0.0, 50.0 * s, 0.0));
      track.append(
          new TrackSample(
              s,
              at.longitudeDeg(),
              at.latitudeDeg(),
              500.0,
              0.0,
              50.0,
              OptionalDouble.empty(),
              0,
              "CRUISE",
              Optional.of(new TrackSample.Flight(0.0, 0.0, 50.0, false))));
    }
    return track;
  }

  @Test
  void breaking_furtherRules_keepsWhatWasCounted() {
    RunOutcome outcome =
        new RunOutcome(1, true, List.of("a"), Map.of("touches", 1), Map.of("distanceM", 2.0))
            .breaking(List.of("b"));

    assertThat(outcome)
        .isEqualTo(
            new RunOutcome(
                1, true, List.of("a", "b"), Map.of("touches", 1), Map.of("distanceM", 2.0)));
  }

  private static RunReport report(double reachM, ObjectDescription... around) {
    Geodetic end = ORIGIN.fromEnu(Point.of(0.0, 15_000.0, 0.0));
    RunPlan plan =
        new RunPlan(
                Domain.AIR,
                Optional.of(new RunPlan.Start(8.0, 50.0, 0.0, 0.0)),
                List.of(
                    new RunPlan.Waypoint(
                        "1",
                        end.longitudeDeg(),
                        end.latitudeDeg(),
                        OptionalDouble.empty(),
                        100.0,
                        OptionalDouble.empty())))
            .among(new Surroundings(List.of(around), reachM));
    return RunReport.of(
        new RunDetails("cessna", 1, "embedded", 1.0, OptionalInt.of(1)),
        plan,
        north(300.0),
        RunOutcome.clean());
  }

  @Test
  void score_towerBesideTheTrack_leastDistanceAndItsTime() {
    ObstacleResult result =
        report(5.5, tower("tower", 300.0, 5_000.0, 200.0)).score().obstacles().get(0);
    assertThat(result.leastM()).isCloseTo(100.0, within(0.5));
    assertThat(result.timeS()).isCloseTo(100.0, within(0.5));
    assertThat(result.touched()).isFalse();
    assertThat(result.moves()).isFalse();
  }

  /** A sphere about the middle of a body, as it is drawn, does not reach the ground. */
  @Test
  void distanceM_walkerWithItsShape_isZeroBesideTheFeet() {
    MovingSphere drawn = new MovingSphere().radius(0.3);
    drawn.uid("p1").referenceFrame(ReferenceFrame.LOCAL_ENU).x(-4.0).y(0.0).z(0.9);
    drawn.timeStep(1.0).trajectory(List.of(Point.of(0.0, 0.0, 0.9)));
    Cylinder body = new Cylinder().radius(0.3).height(1.8);
    body.uid("p1").referenceFrame(ReferenceFrame.LOCAL_ENU).x(-4.0).y(0.0).z(0.9);
    Point feet = Point.of(0.1, 0.0, 0.0);

    assertThat(new Surroundings(List.of(drawn), 0.0).distanceM(drawn, 1.0, feet))
        .isGreaterThan(0.5);
    Surroundings shaped = new Surroundings(List.of(drawn), 0.0, List.of(), Map.of("p1", body));
    assertThat(shaped.distanceM(drawn, 1.0, feet)).isZero();
    assertThat(shaped.distanceM(drawn, 1.0, Point.of(1.3, 0.0, 0.0))).isCloseTo(1.0, within(1e-9));
  }

  @Test
  void score_towerWithinReach_isAViolationAndNoSuccess() {
    RunScore far = report(99.0, tower("tower", 300.0, 5_000.0, 200.0)).score();
    assertThat(far.success()).isTrue();
    RunScore near = report(101.0, tower("tower", 300.0, 5_000.0, 200.0)).score();
    assertThat(near.success()).isFalse();
    assertThat(near.outcome().violations()).hasSize(1);
    assertThat(near.outcome().violations().get(0)).contains("tower").contains("100.0 s");
  }

  @Test
  void score_hindranceWithinReach_isTouchedButNoViolation() {
    ObjectDescription buoy = tower("buoy", 300.0, 5_000.0, 200.0).level(ObjectLevel.HINDRANCE);
    RunScore score = report(101.0, buoy).score();

    assertThat(score.obstacles().get(0).touched()).isTrue();
    assertThat(score.success()).isTrue();
  }

  @Test
  void score_trafficHeadOn_isJudgedWhereItIsThen() {
    ObstacleResult result = report(5.5, southbound(250.0, 50.0)).score().obstacles().get(0);
    assertThat(result.timeS()).isCloseTo(200.0, within(0.6)); // 20 km at 100 m/s
    assertThat(result.leastM()).isCloseTo(150.0, within(2.0)); // 20 km off, north is another
    assertThat(result.moves()).isTrue();
  }

  @Test
  void centre_longWayOverTheEarth_keepsItsHeight() {
    Point there = Surroundings.centreAfter(southbound(0.0, 50.0), 800.0); // 40 km
    assertThat(there.z()).isEqualTo(500.0);
    MovingSphere climbing = southbound(0.0, 50.0);
    climbing.motion().velocity(Point.of(0.0, -50.0, 2.0));
    assertThat(Surroundings.centreAfter(climbing, 100.0).z()).isCloseTo(700.0, within(1.0e-6));
  }

  @Test
  void score_towerInUtm_isJudgedAsInGlobal() {
    ObjectDescription global = tower("tower", 300.0, 5_000.0, 200.0);
    Geodetic at = Geodetic.of(global.center());
    ReferenceFrame frame = UtmGrid.frameAt(at);
    Point grid = new UtmGrid(frame).grid(at);
    ObjectDescription utm = global.copy();
    utm.referenceFrame(frame).x(grid.x()).y(grid.y());

    ObstacleResult result = report(5.5, utm).score().obstacles().get(0);

    assertThat(result.leastM()).isCloseTo(100.0, within(0.5));
    assertThat(result.timeS()).isCloseTo(100.0, within(0.5));
  }

  @Test
  void write_towerInUtm_isInThePicture() throws IOException {
    Geodetic at = ORIGIN.fromEnu(Point.of(900.0, 5_000.0, 0.0));
    Point grid = new UtmGrid(UtmGrid.frameAt(at)).grid(at);
    ObjectDescription mill = new Cylinder().radius(200.0).height(2000.0).uid("old mill");
    mill.referenceFrame(UtmGrid.frameAt(at)).x(grid.x()).y(grid.y());

    report(5.5, mill).write(directory);

    assertThat(Files.readString(directory.resolve("track.svg"))).contains("old mill");
  }

  @Test
  void place_localFrames_goThereAndBack() {
    for (ReferenceFrame frame : List.of(ReferenceFrame.LOCAL_NED, ReferenceFrame.LOCAL_ENU)) {
      ObjectDescription object = new Cylinder().radius(1.0).uid("c").referenceFrame(frame);
      Geodetic place = new Geodetic(8.001, 50.002, 7.0);
      Point in = Surroundings.in(object, place, ORIGIN);
      boolean ned = frame.equals(ReferenceFrame.LOCAL_NED);
      assertThat(ned ? in.x() : in.y()).isCloseTo(222.5, within(0.5)); // north
      assertThat(ned ? -in.z() : in.z()).isCloseTo(7.0, within(1.0e-9)); // up
      Geodetic back = Surroundings.onEarth(object, in, ORIGIN);
      assertThat(back.longitudeDeg()).isCloseTo(place.longitudeDeg(), within(1.0e-8));
      assertThat(back.latitudeDeg()).isCloseTo(place.latitudeDeg(), within(1.0e-8));
    }
  }

  @Test
  void write_surroundings_areInSummaryAndPicture() throws IOException {
    report(5.5, tower("old mill", 900.0, 5_000.0, 200.0), southbound(600.0, 50.0)).write(directory);
    String summary = Files.readString(directory.resolve("summary.json"));
    assertThat(summary)
        .contains("\"obstacles\" : [")
        .contains("\"name\" : \"old mill\"")
        .containsPattern("\"leastDistanceM\" : 700\\.[0-9]+")
        .contains("\"touched\" : false");
    String picture = Files.readString(directory.resolve("track.svg"));
    assertThat(picture).contains("old mill").contains("N1 3:20");
  }

  @Test
  void write_nothingAround_summaryHasNoObstacles() throws IOException {
    report(5.5).write(directory);
    assertThat(Files.readString(directory.resolve("summary.json"))).doesNotContain("obstacles");
  }
}
