package org.u2sa.trials.terminal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import net.sf.geographiclib.Geodesic;
import net.sf.geographiclib.GeodesicData;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunDetails;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.RunScore;
import org.u2sa.report.score.Track;
import org.u2sa.report.score.TrackSample;
import org.u2sa.report.summary.RunReport;
import org.u2sa.report.summary.RunSeries;

/** Reports of a ground vehicle: metres instead of kilometres, and nothing that only flies. */
class GroundRunTest {
  private static final double OFF_LINE_M = 0.3;
  private static final double[][] CORNERS = {{0, 20}, {20, 20}, {0, 20}, {20, 20}};

  @TempDir private Path directory;

  private static GeodesicData at(double eastM, double northM) {
    return Geodesic.WGS84.Direct(
        29.1885, -81.0478, Math.toDegrees(Math.atan2(eastM, northM)), Math.hypot(eastM, northM));
  }

  private static TrackSample sample(double timeS, double eastM, double northM, int leg) {
    GeodesicData place = at(eastM, northM);
    return new TrackSample(
        timeS,
        place.lon2,
        place.lat2,
        0.0,
        -1.0,
        1.0,
        OptionalDouble.of(0.25),
        leg,
        "DRIVES",
        Optional.empty());
  }

  /** From corner to corner at 1 m/s, beside the lines by the same distance. */
  private static RunReport report() {
    return report(0);
  }

  private static RunReport report(int contacts) {
    List<RunPlan.Waypoint> waypoints = new ArrayList<>();
    for (double[] corner : CORNERS) {
      GeodesicData place = at(corner[0], corner[1]);
      waypoints.add(
          new RunPlan.Waypoint(
              "gate " + waypoints.size(),
              place.lon2,
              place.lat2,
              OptionalDouble.empty(),
              2.0,
              OptionalDouble.empty()));
    }
    RunPlan plan =
        new RunPlan(
            Domain.GROUND, Optional.of(new RunPlan.Start(-81.0478, 29.1885, 0.0, 0.0)), waypoints);
    Track track = new Track();
    for (int i = 0; i < 800; i++) {
      int leg = i / 200;
      double along = i % 200 / 10.0;
      double east = leg == 0 ? 0.0 : leg == 2 ? 20.0 - along : along;
      double north = leg == 0 ? along : 20.0 + OFF_LINE_M;
      track.append(sample(0.1 * i, east, north, leg));
    }
    track.append(sample(80.0, 20.0, 20.0, CORNERS.length));
    return RunReport.of(
        new RunDetails("ugv", 3, "Mini-Molle", 1.0, OptionalInt.of(4)),
        plan,
        track,
        new RunOutcome(contacts, false, List.of("moved unarmed at 3.0 s, at 0.10 m/s")));
  }

  @Test
  void score_besideTheLineOfShortLegs_isMeasuredAfterTheFirstMetres() {
    RunScore score = report().score();

    assertThat(score.captured()).isEqualTo(4);
    assertThat(score.crossTrackRmsM().getAsDouble()).isCloseTo(OFF_LINE_M, within(0.01));
    assertThat(score.flight()).isEmpty();
  }

  @Test
  void write_summary_holdsNothingOfFlight() throws IOException {
    report().write(directory);
    JsonNode json = new ObjectMapper().readTree(directory.resolve(RunReport.SUMMARY).toFile());

    assertThat(json.get("goals").asInt()).isEqualTo(4);
    assertThat(json.get("goalsCompleted").asInt()).isEqualTo(4);
    assertThat(json.get("contacts").asInt()).isZero();
    assertThat(json.get("violations").asInt()).isEqualTo(1);
    assertThat(json.get("settlingDistanceM").asDouble()).isEqualTo(3.0);
    assertThat(json.get("perWaypoint").get(1).get("missM").asDouble()).isLessThan(0.4);
    assertThat(json.get("absent")).isEmpty();
    for (String inFlight : List.of("tookOff", "stalled", "altitudeRmsM", "maxBankDeg")) {
      assertThat(json.has(inFlight)).as(inFlight).isFalse();
    }
  }

  @Test
  void write_csvKmlAndPicture_areOfTheGround() throws IOException {
    report().write(directory);

    assertThat(Files.readString(directory.resolve("track.csv")).lines().limit(2))
        .containsExactly(
            "time_s,longitude_deg,latitude_deg,altitude_m,heading_deg,ground_speed_mps,cross_track_m,leg,phase",
            "0.000,-81.04780000,29.18850000,0.000,-57.296,1.000,0.250,0,DRIVES");
    assertThat(Files.readString(directory.resolve("track.kml")))
        .contains("clampToGround", "<name>driven</name>")
        .doesNotContain("absolute");
    String picture = Files.readString(directory.resolve("track.svg"));
    assertThat(picture)
        .contains("speed over ground", "to the right of the line [m]", "m east and north of home")
        .contains("gate 1")
        .doesNotContain("gate 2"); // where gate 0 is
  }

  @Test
  void series_summary_holdsTheWorstOfAll() throws IOException {
    StringWriter text = new StringWriter();
    new RunSeries(List.of(report(), report())).writeSummary(text);
    JsonNode json = new ObjectMapper().readTree(text.toString());

    assertThat(json.get("runsSucceeded").asInt()).isZero(); // it moved unarmed
    assertThat(json.get("worstCrossTrackRmsM").asDouble()).isCloseTo(OFF_LINE_M, within(0.01));
    assertThat(json.get("perRun").get(0).get("contacts").asInt()).isZero();
    assertThat(json.has("worstBankDeg")).isFalse();
  }

  @ParameterizedTest
  @CsvSource({"1, 1 contact", "2, 2 contacts"})
  void terminal_contacts_areNoSuccess(int contacts, String words) {
    StringWriter text = new StringWriter();
    RunReport report = report(contacts);
    Terminal terminal = new Terminal(new PrintWriter(text), false, false, 100);
    WaypointTable.print(terminal, report.facts(), report.score());

    assertThat(text.toString().lines()).contains("no success: " + words);
  }

  @Test
  void terminal_tableAndStatus_sayCentimetresAndNoAltitude() {
    StringWriter text = new StringWriter();
    Terminal terminal = new Terminal(new PrintWriter(text), false, false, 100);
    WaypointTable.print(terminal, report().facts(), report().score());
    LiveStatus live = new LiveStatus(terminal);
    live.update(new LiveStatus.Moment(sample(65.0, 1.0, 2.0, 1), 2, 4, "gate 1", () -> 12.34, 1.0));

    assertThat(text.toString().lines())
        .contains(
            "     waypoint  miss [m]      time  captured",
            "  1  gate 0        0.00      0:20  yes",
            "contacts 0",
            "violation: moved unarmed at 3.0 s, at 0.10 m/s",
            "01:05  DRIVES     waypoint 2 of 4 (gate 1), 12.3 m to go  speed 1.00 m/s  heading 303 deg  off track +0.25 m  elapsed 00:01");
  }
}
