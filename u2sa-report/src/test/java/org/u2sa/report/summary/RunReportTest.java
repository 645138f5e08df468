package org.u2sa.report.summary;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunDetails;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.SyntheticFlight;
import org.u2sa.report.score.Track;
import org.u2sa.report.score.TrackSample;
import org.w3c.dom.Document;

class RunReportTest {

  @TempDir private Path directory;

  private static Document parsed(Path file) throws Exception {
    DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
    factory.setNamespaceAware(true);
    return factory.newDocumentBuilder().parse(file.toFile());
  }

  private JsonNode summary() throws IOException {
    return new ObjectMapper().readTree(directory.resolve(RunReport.SUMMARY).toFile());
  }

  @Test
  void write_wholeFlight_leavesAllFilesAndNothingElse() {
    SyntheticFlight.report(10).write(directory);
    assertThat(directory.toFile().list())
        .containsExactlyInAnyOrder(
            "summary.json", "track.csv", "track.kml", "track.svg", "track.png");
  }

  @Test
  void write_sameFlightTwice_givesTheSameBytes() throws IOException {
    SyntheticFlight.report(10).write(directory.resolve("a"));
    SyntheticFlight.report(10).write(directory.resolve("b"));
    for (String name : directory.resolve("a").toFile().list()) {
      assertThat(directory.resolve("b").resolve(name))
          .as(name)
          .hasSameBinaryContentAs(directory.resolve("a").resolve(name));
    }
  }

  @Test
  void write_wholeFlight_summaryHoldsTheFigures() throws IOException {
    RunReport report = SyntheticFlight.report(10);
    report.write(directory);
    JsonNode json = summary();
    assertThat(json.get("seed").asLong()).isEqualTo(7);
    assertThat(json.get("simulator").asText()).isEqualTo("embedded C172");
    assertThat(json.get("waypoints").asInt()).isEqualTo(10);
    assertThat(json.get("waypointsCaptured").asInt()).isEqualTo(10);
    assertThat(json.get("goals").asInt()).isEqualTo(10);
    assertThat(json.get("goalsCompleted").asInt()).isEqualTo(10);
    assertThat(json.get("tookOff").asBoolean()).isTrue();
    assertThat(json.get("crashed").asBoolean()).isFalse();
    assertThat(json.get("violations").asInt()).isZero();
    assertThat(json.get("maxBankDeg").asDouble()).isCloseTo(Math.toDegrees(0.1), within(0.001));
    assertThat(json.get("simSecondsPerSecond").asDouble())
        .isCloseTo(report.score().simSeconds() / 12.5, within(0.001));
    JsonNode first = json.get("perWaypoint").get(0);
    assertThat(first.get("name").asText()).isEqualTo("Departure");
    assertThat(first.get("missM").asDouble()).isBetween(0.0, 100.0);
    assertThat(first.get("captured").asBoolean()).isTrue();
    assertThat(json.get("absent")).isEmpty();
  }

  @Test
  void write_flightThatNeverLeft_saysWhyNumbersAreAbsent() throws IOException {
    RunPlan plan = SyntheticFlight.tenWaypoints();
    RunDetails facts = new RunDetails("cessna", 1, "embedded", 0.0, OptionalInt.of(0));
    RunReport.of(facts, plan, new Track(), RunOutcome.clean()).write(directory);
    JsonNode json = summary();
    assertThat(json.get("crossTrackRmsM").isNull()).isTrue();
    assertThat(json.get("absent").get("crossTrackRmsM").asText()).contains("no straight");
    assertThat(json.get("absent").get("Ridge: missM").asText()).contains("was never the target");
    assertThat(Files.readString(directory.resolve(RunReport.SUMMARY))).doesNotContain("NaN");
  }

  @Test
  void write_names_areEscapedInKmlAndSvg() throws Exception {
    RunPlan.Waypoint odd =
        new RunPlan.Waypoint(
            "<Tower & \"Co\">",
            -157.9,
            21.3,
            OptionalDouble.of(300.0),
            100.0,
            OptionalDouble.empty());
    RunPlan plan = new RunPlan(Domain.AIR, Optional.empty(), List.of(odd));
    RunDetails facts = new RunDetails("a<b", 1, "x & y", 1.0, OptionalInt.empty());
    RunReport.of(facts, plan, new Track(), RunOutcome.clean()).write(directory);
    assertThat(
            parsed(directory.resolve("track.kml"))
                .getElementsByTagName("Placemark")
                .item(1)
                .getTextContent())
        .contains("<Tower & \"Co\">");
    assertThat(parsed(directory.resolve("track.svg")).getDocumentElement().getTextContent())
        .contains("<Tower & \"Co\">");
  }

  @Test
  void write_wholeFlight_kmlHasTrackAndWaypoints() throws Exception {
    SyntheticFlight.report(10).write(directory);
    Document kml = parsed(directory.resolve("track.kml"));
    assertThat(kml.getDocumentElement().getNamespaceURI())
        .isEqualTo("http://www.opengis.net/kml/2.2");
    assertThat(kml.getElementsByTagName("LineString").getLength()).isEqualTo(2);
    assertThat(kml.getElementsByTagName("Point").getLength()).isEqualTo(10);
    assertThat(kml.getElementsByTagName("altitudeMode").item(0).getTextContent())
        .isEqualTo("absolute");
    String[] first =
        kml.getElementsByTagName("coordinates")
            .item(0)
            .getTextContent()
            .strip()
            .split("\\s+")[0]
            .split(",");
    assertThat(Double.parseDouble(first[0])).isCloseTo(SyntheticFlight.LONGITUDE, within(1e-6));
    assertThat(Double.parseDouble(first[1])).isCloseTo(SyntheticFlight.LATITUDE, within(1e-6));
    assertThat(Double.parseDouble(first[2])).isCloseTo(4.0, within(1e-6));
  }

  @Test
  void write_wholeFlight_svgNamesEachWaypoint() throws Exception {
    SyntheticFlight.report(10).write(directory);
    Document svg = parsed(directory.resolve("track.svg"));
    assertThat(svg.getDocumentElement().getAttribute("viewBox")).isEqualTo("0 0 1600 1200");
    assertThat(svg.getDocumentElement().getTextContent())
        .contains("10 of 10", "Lighthouse", "cross-track RMS", "home");
  }

  @Test
  void write_wholeFlight_pngIsAPicture() throws IOException {
    SyntheticFlight.report(10).write(directory);
    BufferedImage image = ImageIO.read(directory.resolve("track.png").toFile());
    assertThat(image.getWidth()).isEqualTo(1600);
    assertThat(image.getHeight()).isEqualTo(1200);
    Set<Integer> colours = new HashSet<>();
    for (int y = 130; y < 780; y++) {
      for (int x = 90; x < 1550; x++) {
        colours.add(image.getRGB(x, y));
      }
    }
    assertThat(colours).hasSizeGreaterThan(50);
  }

  @Test
  void write_trackCsv_isGolden() throws IOException {
    RunDetails facts = new RunDetails("cessna", 1, "embedded", 1.0, OptionalInt.empty());
    Track track = new Track();
    track.append(
        new TrackSample(
            0.0,
            -157.92,
            21.32,
            4.0,
            Math.PI,
            0.0,
            OptionalDouble.of(-1.25),
            0,
            "TAKE-OFF, ROLL",
            Optional.of(new TrackSample.Flight(-0.1, 0.05, 0.0, true))));
    track.append(
        new TrackSample(
            0.05,
            -157.9200001,
            21.32,
            4.0,
            Math.PI,
            50.0,
            OptionalDouble.empty(),
            1,
            "CLIMB",
            Optional.of(new TrackSample.Flight(0.0, 0.0, 51.4444, false))));
    RunReport.of(facts, SyntheticFlight.twoWaypoints(), track, RunOutcome.clean()).write(directory);
    assertThat(Files.readString(directory.resolve("track.csv")))
        .isEqualTo(
            "time_s,longitude_deg,latitude_deg,altitude_m,heading_deg,roll_deg,pitch_deg,calibrated_airspeed_mps,ground_speed_mps,"
                + "cross_track_m,leg,on_ground,phase\n"
                + "0.000,-157.92000000,21.32000000,4.000,180.000,-5.730,2.865,0.000,0.000,-1.250,0,1,\"TAKE-OFF, ROLL\"\n"
                + "0.050,-157.92000010,21.32000000,4.000,180.000,0.000,0.000,51.444,50.000,,1,0,CLIMB\n");
  }

  @Test
  void write_directoryInTheWay_namesThePathAndLeavesNoSummary() throws IOException {
    Files.createDirectories(directory.resolve("track.kml/full"));
    Files.writeString(directory.resolve(RunReport.SUMMARY), "{}"); // of an earlier run
    assertThatThrownBy(() -> SyntheticFlight.report(10).write(directory))
        .isInstanceOf(RunFailedException.class)
        .hasMessageContaining("cannot write")
        .hasMessageContaining(directory.resolve("track.kml").toString());
    assertThat(directory.resolve(RunReport.SUMMARY)).doesNotExist();
    assertThat(directory.toFile().list((File d, String name) -> name.endsWith(".part"))).isEmpty();
  }

  @Test
  void prepare_fileInTheWay_isBadInput() throws IOException {
    Path file = Files.createFile(directory.resolve("out"));
    assertThatThrownBy(() -> RunReport.prepare(file))
        .isInstanceOf(BadInputException.class)
        .hasMessage("cannot write to " + file + ": a file of that name already exists");
  }

  @Test
  void prepare_newDirectory_makesItAndLeavesItEmpty() {
    RunReport.prepare(directory.resolve("a/b"));
    assertThat(directory.resolve("a/b")).isEmptyDirectory();
  }
}
