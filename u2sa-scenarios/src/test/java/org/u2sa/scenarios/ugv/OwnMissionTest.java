package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.scenarios.run.CommandLineRun;

/** Missions that nobody tuned for, judged by their own thresholds. */
class OwnMissionTest {
  private static final Geodetic HAWAII = new Geodetic(-157.9, 21.3, 0.0);

  @TempDir private Path directory;

  /** A mission over corners [m north, east of home], perhaps with a threshold [m]. */
  private Path mission(Geodetic home, String threshold, double[]... corners) throws IOException {
    StringBuilder text = new StringBuilder("<mission>\n");
    text.append(
        String.format(
            Locale.ROOT,
            "<home><x>%.9f</x><y>%.9f</y><psi>0</psi></home>\n",
            home.longitudeDeg(),
            home.latitudeDeg()));
    for (double[] corner : corners) {
      Geodetic place = home.fromNed(Point.of(corner[0], corner[1], 0.0));
      text.append(
          String.format(
              Locale.ROOT,
              "<waypoint><y>%.9f</y><x>%.9f</x>%s</waypoint>\n",
              place.latitudeDeg(),
              place.longitudeDeg(),
              threshold.isEmpty()
                  ? ""
                  : "<horizontalThreshold>" + threshold + "</horizontalThreshold>"));
    }
    return Files.writeString(directory.resolve("own.xml"), text + "</mission>\n");
  }

  private CommandLineRun drive(Path mission, String... more) {
    String[] options = new String[more.length + 2];
    options[0] = "--mission";
    options[1] = mission.toString();
    System.arraycopy(more, 0, options, 2, more.length);
    return CommandLineRun.demo("ugv", directory.resolve("out"), options);
  }

  private static void requireAll(CommandLineRun run, int goals, double withinM) {
    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    JsonNode summary = run.summary();
    assertThat(summary.get("goalsCompleted").asInt()).isEqualTo(goals);
    assertThat(summary.get("waypointsCaptured").asInt()).as(run.out()).isEqualTo(goals);
    assertThat(summary.get("absent").toString()).doesNotContain("was never the target");
    for (JsonNode waypoint : summary.get("perWaypoint")) {
      assertThat(waypoint.get("missM").asDouble()).as(waypoint.toString()).isLessThan(withinM);
    }
  }

  @Tag("long")
  @Test
  void demo_eightBareWaypoints_passesEachWithinTheVehiclesOwnThreshold() throws IOException {
    Path bare =
        mission(
            HAWAII,
            "",
            new double[][] {
              {15, 0}, {25, 12}, {10, 20}, {-5, 8}, {-12, -9}, {4, -20}, {18, -12}, {2, 2}
            });

    requireAll(drive(bare), 8, 0.5);
  }

  @ParameterizedTest(name = "longitude {0}, latitude {1}")
  @CsvSource({"179.9999, 10.0", "15.6, 78.2"})
  void demo_zigZagElsewhereOnEarth_passesEach(double longitudeDeg, double latitudeDeg)
      throws IOException {
    double[][] zigZag = {{-4, 0}, {2, 6}, {-4, 12}, {2, 18}, {-4, 12}, {30, 12}};

    requireAll(
        drive(mission(new Geodetic(longitudeDeg, latitudeDeg, 0.0), "", zigZag)),
        zigZag.length,
        0.5);
  }

  @Tag("long")
  @ParameterizedTest(name = "longitude {0}, latitude {1}")
  @CsvSource({"-70.9, -53.1", "-179.99995, -16.5", "0.0, 0.0"})
  void demo_zigZagAtMorePlacesOnEarth_passesEach(double longitudeDeg, double latitudeDeg)
      throws IOException {
    demo_zigZagElsewhereOnEarth_passesEach(longitudeDeg, latitudeDeg);
  }

  @Test
  void demo_thresholdSetForTheRun_isWhatTheScoreGoesBy() throws IOException {
    CommandLineRun run =
        drive(
            mission(HAWAII, "", new double[][] {{10, 0}, {10, 10}}),
            "--set",
            "MissionManager:DEFAULT THRESHOLD=1.5");

    requireAll(run, 2, 1.5);
    assertThat(Files.readString(directory.resolve("out/mission.xml")))
        .contains("<horizontalThreshold>1.5</horizontalThreshold>");
  }

  @ParameterizedTest(name = "{0} m apart")
  @ValueSource(doubles = {0.1, 0.3, 0.5})
  void demo_waypointsNearToEachOther_eachIsScored(double apartM) throws IOException {
    double[][] row = new double[6][];
    for (int i = 0; i < row.length; i++) {
      row[i] = new double[] {8.0 + i * apartM, 0.0};
    }

    requireAll(drive(mission(HAWAII, "0.5", row)), row.length, 0.5);
  }

  @Test
  void demo_waypointsThatComeAgain_eachVisitIsScored() throws IOException {
    double[][] twice = {{8, 0}, {8, 8}, {8, 0}, {8, 8}, {8, 8}, {8, 0}};

    requireAll(drive(mission(HAWAII, "0.5", twice)), twice.length, 0.5);
  }

  @Test
  void demo_thresholdLongerThanTheLegs_eachIsScored() throws IOException {
    double[][] near = {{6, 0}, {8, 1}, {9, 3}, {8, 5}, {6, 6}};

    requireAll(drive(mission(HAWAII, "5", near)), near.length, 5.0);
  }
}
