package org.u2sa.scenarios.igvc;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.frame.Point;
import org.u2sa.scenarios.run.CommandLineRun;

/**
 * Rows of barrels, seen by the laser alone: a vehicle 0.92 m wide goes through a gap of 1.524 m,
 * and leaves one of 1.1 m alone for a wider one aside. The row's angle, the gap's place and all
 * noise follow from the seed.
 */
class GapTest {
  private static final double DECOY_M = 1.1;
  private static final double WIDE_M = 2.2;
  private static final double ASIDE_M = 4.2; // from the decoy to the wide gap
  private static final double NARROW_M = 1.524; // 5 ft, the rules' narrowest passage
  private static final double ROW_M = 8.0; // to each side: farther than the way through
  private static final double LONG_ROW_M = 16.0; // farther than the laser sees
  private static final double AROUND_M = 25.0; // a way shorter than this leads through the gap
  private static final double SPACING_M = 0.9;
  private static final double MAX_ANGLE = Math.toRadians(25.0);

  /** As long as no camera is needed. */
  private static final String[] LASER_ALONE = {
    "--camera-dies", "0", "--set", "HealthMonitor:CourseCamera POLICY=ALERT"
  };

  @TempDir private Path directory;

  /** A row of barrels, with gaps at these places along it. */
  private static Course row(long seed, double halfM, double[] middles, double[] widths) {
    SplittableRandom random = new SplittableRandom(seed);
    double angle = MAX_ANGLE * (2.0 * random.nextDouble() - 1.0);
    double ahead = 5.0 + random.nextDouble();
    double shift = 2.0 * random.nextDouble() - 1.0;
    CourseBuilder builder =
        new CourseBuilder(Point.ORIGIN, 2.0 * Math.PI * random.nextDouble(), random.nextBoolean());
    builder.start(Point.ORIGIN, Point.of(1.0, 0.0, 0.0));
    builder.waypoint(Point.of(ahead + 6.0, shift, 0.0));
    double place = -halfM;
    for (int i = 0; i <= middles.length; i++) {
      boolean isLast = i == middles.length;
      double end = isLast ? halfM : middles[i] - 0.5 * widths[i] - CourseBuilder.BARREL_RADIUS_M;
      int steps = (int) Math.ceil((end - place) / SPACING_M);
      for (int k = 0; k <= steps; k++) {
        builder.barrel(on(place + (end - place) * k / steps + shift, ahead, angle));
      }
      place = isLast ? end : middles[i] + 0.5 * widths[i] + CourseBuilder.BARREL_RADIUS_M;
      if (!isLast && widths[i] == DECOY_M) { // the judge calls who goes in there
        builder.line(
            Course.BOUNDARY,
            List.of(on(end + shift, ahead, angle), on(place + shift, ahead, angle)));
      }
    }
    return builder.course("row " + seed);
  }

  private static Point on(double along, double ahead, double angle) {
    return Point.of(ahead - along * Math.sin(angle), along * Math.cos(angle), 0.0);
  }

  private CommandLineRun drive(Course course, long seed, String... more) {
    List<String> options = new ArrayList<>(List.of(LASER_ALONE));
    options.addAll(List.of(more));
    return IgvcRun.of(
        directory.resolve("run " + seed), course, seed, options.toArray(new String[0]));
  }

  private static void requireClean(CommandLineRun run) {
    assertThat(run.figure("waypointsCaptured")).as(run.said()).isEqualTo(1);
    assertThat(run.figure("touches")).as(run.said()).isZero();
    assertThat(run.figure("lineCrossings")).as(run.said()).isZero();
  }

  private void refuse(long seed) {
    double aside = seed % 2 == 0 ? ASIDE_M : -ASIDE_M;
    double[] middles = {Math.min(0.0, aside), Math.max(0.0, aside)};
    double[] widths = {aside < 0.0 ? WIDE_M : DECOY_M, aside < 0.0 ? DECOY_M : WIDE_M};
    requireClean(drive(row(seed, ROW_M, middles, widths), seed));
  }

  private void thread(long seed, double gapM, String... more) {
    Course course = row(seed, LONG_ROW_M, new double[] {0.0}, new double[] {gapM});
    CommandLineRun run = drive(course, seed, more);
    requireClean(run);
    assertThat(run.summary().path("distanceM").asDouble()).as(run.said()).isLessThan(AROUND_M);
  }

  @ParameterizedTest
  @ValueSource(longs = 3)
  void demo_narrowestGapOfTheRules_isThreaded(long seed) {
    thread(seed, NARROW_M);
  }

  /** Rows whose barrels were touched while the vehicle turned later than it was told. */
  @ParameterizedTest
  @ValueSource(longs = 3)
  void demo_narrowerVehicle_threadsAGapTooNarrowForTheUsualOne(long seed) {
    thread(seed, 1.2, "--width", "0.62");
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(longs = {7, 9})
  void demo_narrowerVehicleOtherRows_threadsAGapTooNarrowForTheUsualOne(long seed) {
    demo_narrowerVehicle_threadsAGapTooNarrowForTheUsualOne(seed);
  }

  @Test
  void demo_vehicleOfAnImpossibleWidth_isRefused() {
    CommandLineRun run =
        drive(row(1, ROW_M, new double[] {0.0}, new double[] {2.0}), 1, "--width", "3");
    assertThat(run.exitCode()).isNotZero();
    assertThat(run.said()).contains("--width 3.0: expected 0.5…1.2 m");
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(
      longs = {61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80})
  void demo_twentyNarrowestGapsOfTheRules_areThreaded(long seed) {
    thread(seed, NARROW_M);
  }

  @ParameterizedTest
  @ValueSource(longs = 2)
  void demo_gapTooNarrow_isLeftAlone(long seed) {
    refuse(seed);
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(
      longs = {41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60})
  void demo_twentyGapsTooNarrow_areLeftAlone(long seed) {
    refuse(seed);
  }
}
