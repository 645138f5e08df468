package org.u2sa.cli.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.CommandFixture;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.UtmGrid;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.mcap.ChunkCompression;
import org.u2sa.recorder.mcap.McapOptions;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.McapWriter;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;

/** A vehicle that goes north for 10 s, and first knows only where it is from where it began. */
class ExportTest extends CommandFixture {
  @TempDir private Path folder;
  private final Map<String, McapChannel> channels = new HashMap<>();
  private Path recording;

  @BeforeEach
  void write() throws IOException {
    try (McapWriter writer = writer("run")) {
      Waypoint goal = new Waypoint().uid("<a>").x(8.0).y(50.001).horizontalThreshold(2.0);
      write(writer, 0, Channels.GOALS, new GoalList().goals(List.of(goal.copy())));
      write(writer, 0, Channels.STATE, state().referenceFrame(ReferenceFrame.LOCAL_ENU).x(1.5));
      for (int i = 1; i <= 10; i++) {
        write(writer, i, Channels.STATE, state().x(8.0).y(50.0 + i * 1e-4).z(100.0 + i));
      }
      write(
          writer,
          10,
          Channels.ACTUATION,
          new PercentageCommand().percentage(-12.5).actuatorName("LEFT, \"fast\""));
      goal.completed(true);
      write(writer, 10, Channels.GOAL_REPORTS, goal.copy());
    }
  }

  private McapWriter writer(String name) throws IOException {
    recording = folder.resolve(name + ".mcap");
    channels.clear();
    return new McapWriter(
        Files.newByteChannel(recording, StandardOpenOption.CREATE, StandardOpenOption.WRITE),
        McapOptions.usual(ChunkCompression.LZ4, "test"));
  }

  private static StateInformation state() {
    return new StateInformation().sensorName("filter");
  }

  @Test
  void csv_folderCannotBeCreated_isSaidWithItsName() throws IOException {
    Path file = Files.writeString(folder.resolve("file.xml"), "");
    String target = file.resolve("tables").toString();
    assertThat(u2sa("export", recording.toString(), "--format", "csv", "--out", target))
        .isEqualTo(ExitCode.FAILED);
    assertThat(err.toString().lines())
        .singleElement()
        .asString()
        .startsWith("u2sa: cannot read or write " + file)
        .doesNotContain("unexpected");
  }

  /** A vehicle that goes east over the antimeridian, and back. */
  private void writeOverTheAntimeridian() throws IOException {
    try (McapWriter writer = writer("antimeridian")) {
      double[] longitudes = {179.9, 180.0, 180.1, -179.8, 179.9};
      for (int i = 0; i < longitudes.length; i++) {
        write(writer, i, Channels.STATE, state().x(longitudes[i]).y(10.0 + i).z(100.0));
      }
      Waypoint goal = new Waypoint().uid("a").x(180.0).y(10.0).horizontalThreshold(2.0);
      write(writer, 5, Channels.GOALS, new GoalList().goals(List.of(goal)));
    }
  }

  @Test
  void gpx_antimeridian_isCutThereAndHasLongitudesBelow180() throws IOException {
    writeOverTheAntimeridian();
    XmlElement gpx = XmlReader.read(exported("--format", "gpx"), "gpx");
    assertThat(gpx.children("trk").get(0).children("trkseg"))
        .extracting(
            part ->
                part.children("trkpt").stream()
                    .map(point -> point.optionalAttribute("lon").orElseThrow())
                    .toList())
        .containsExactly(
            List.of("179.900000000"),
            List.of("-180.000000000", "-179.900000000", "-179.800000000"),
            List.of("179.900000000"));
    assertThat(gpx.children("wpt").get(0).optionalAttribute("lon")).contains("-180.000000000");
  }

  @Test
  void geojson_antimeridian_isCutThere() throws IOException {
    writeOverTheAntimeridian();
    JsonNode line =
        new ObjectMapper().readTree(exported("--format", "geojson").toFile()).at("/features/0");
    assertThat(line.at("/geometry/type").asText()).isEqualTo("MultiLineString");
    assertThat(line.at("/geometry/coordinates").toString())
        .isEqualTo(
            "[[[179.9,10.0,100.0],[180.0,11.0,100.0],[180.0,11.0,100.0]],"
                + "[[-180.0,11.0,100.0],[-179.9,12.0,100.0],[-179.8,13.0,100.0],"
                + "[-180.0,13.666666667,100.0]],"
                + "[[180.0,13.666666667,100.0],[179.9,14.0,100.0]]]");
    assertThat(line.at("/properties/coordTimes")).hasSize(3);
    assertThat(line.at("/properties/coordTimes/2/0").asText())
        .startsWith("2023-11-14T22:13:23.666");
  }

  @Test
  void kml_antimeridian_isCutThere() throws IOException {
    writeOverTheAntimeridian();
    XmlElement placemark =
        XmlReader.read(exported("--format", "kml"), "kml")
            .children("Document")
            .get(0)
            .children("Placemark")
            .get(0);
    List<XmlElement> tracks = placemark.children("gx:MultiTrack").get(0).children("gx:Track");
    assertThat(tracks).hasSize(3);
    assertThat(tracks.get(1).children("gx:coord"))
        .extracting(XmlElement::text)
        .containsExactly(
            "-180.000000000 11.000000000 100.000",
            "-179.900000000 12.000000000 100.000",
            "-179.800000000 13.000000000 100.000",
            "-180.000000000 13.666666667 100.000");
    assertThat(tracks).allMatch(t -> t.children("when").size() == t.children("gx:coord").size());
  }

  /** Two sensors of one class, which share a topic. */
  private void writeTwoSensors() throws IOException {
    try (McapWriter writer = writer("sensors")) {
      for (int i = 0; i < 6; i++) {
        for (String sensor : List.of("gps-1", "gps-2")) {
          StateInformation state = new StateInformation().sensorName(sensor).x(8.0).y(50.0);
          write(writer, i, Channels.SENSED_STATE, state);
        }
      }
    }
  }

  @Test
  void csv_spacingOfTheRate_leavesNothingOut() throws IOException {
    try (McapWriter writer = writer("fast")) {
      for (int i = 0; i < 200; i++) {
        write(writer, i / 50.0, Channels.STATE, state().x(8.0).y(50.0));
      }
    }
    Path tables = exported("--format", "csv", "--every", "0.1");
    assertThat(Files.readAllLines(tables.resolve("state-StateInformation.csv"))).hasSize(41);
  }

  /** File systems take names of 255 bytes. */
  @Test
  void csv_sourcesWithVeryLongNames_haveATableEach() throws IOException {
    String name = "\uD835\uDC9C".repeat(100);
    try (McapWriter writer = writer("long")) {
      for (String end : List.of("a", "b")) {
        ActuatorAnnouncement announced =
            new ActuatorAnnouncement().actuatorName(name + end).minimum(0.0).maximum(1.0);
        write(writer, 1.0, Channels.ACTUATORS, announced);
      }
    }
    Path tables = exported("--format", "csv");
    try (Stream<Path> files = Files.list(tables)) {
      assertThat(files).hasSize(2);
    }
  }

  @Test
  void csv_spacing_keepsBothSensorsOfAClass() throws IOException {
    writeTwoSensors();
    Path tables = exported("--format", "csv", "--every", "2");
    assertThat(Files.readAllLines(tables.resolve("sensed-state-StateInformation.csv")))
        .extracting(line -> line.split(",")[0] + " " + line.split(",")[2])
        .containsExactly(
            "time [s] sensorName",
            "0.000000 gps-1",
            "0.000000 gps-2",
            "2.000000 gps-1",
            "2.000000 gps-2",
            "4.000000 gps-1",
            "4.000000 gps-2");
  }

  @Test
  void mcap_spacing_keepsBothSensorsOfAClass() throws IOException {
    writeTwoSensors();
    Path exported = exported("--format", "mcap", "--every", "2");
    try (McapReader reader = McapReader.open(exported)) {
      assertThat(reader.statistics().messages()).isEqualTo(6);
    }
  }

  private void write(McapWriter writer, double second, Channel<?> channel, U2SAData message)
      throws IOException {
    message.timestamp(1_700_000_000_000_000L + Math.round(second * 1e6));
    String topic = Topic.of("rover", channel, message).toString();
    McapChannel known = channels.get(topic);
    if (known == null) {
      known = new McapChannel(channels.size() + 1, 0, topic, "cbor", Map.of());
      channels.put(topic, known);
      writer.add(known);
    }
    long nanos = 1_700_000_000_000_000_000L + Math.round(second * 1e9);
    writer.add(new McapMessage(known.id(), 0, nanos, nanos, message.serialize()));
  }

  private int export(String... arguments) {
    String[] all = new String[arguments.length + 2];
    all[0] = "export";
    all[1] = recording.toString();
    System.arraycopy(arguments, 0, all, 2, arguments.length);
    return u2sa(all);
  }

  private Path exported(String... arguments) {
    Path exported = folder.resolve("exported");
    String[] all = new String[arguments.length + 2];
    System.arraycopy(arguments, 0, all, 0, arguments.length);
    all[arguments.length] = "--out";
    all[arguments.length + 1] = exported.toString();
    assertThat(export(all)).as(err.toString()).isEqualTo(ExitCode.DONE);
    return exported;
  }

  @Test
  void csv_fieldInTwoUnits_hasAColumnForEach() throws IOException {
    List<String> lines =
        Files.readAllLines(
            exported("--format", "csv", "--channel", "state")
                .resolve("state-StateInformation.csv"));
    assertThat(lines.get(0))
        .isEqualTo("time [s],timestamp [us],sensorName,referenceFrame,x [m],x [deg],y [deg],z [m]");
    assertThat(lines.get(1)).startsWith("0.000000,").endsWith(",filter,LOCAL_ENU,1.5,,,");
    assertThat(lines.get(2)).startsWith("1.000000,").endsWith(",filter,GLOBAL,,8.0,50.0001,101.0");
    assertThat(lines).hasSize(12);
  }

  @Test
  void csv_textWithCommaAndQuotes_isQuoted() throws IOException {
    Path tables = exported("--format", "csv");
    assertThat(Files.readString(tables.resolve("actuation-PercentageCommand.csv")))
        .contains(",\"LEFT, \"\"fast\"\"\",")
        .contains("-12.5");
    assertThat(Files.readString(tables.resolve("goals-GoalList.csv")))
        .contains("\"[{\"\"type\"\":\"\"Waypoint\"\"");
  }

  @Test
  void csv_partAndSpacing_leaveTheRestOut() throws IOException {
    Path tables = exported("--format", "csv", "--from", "2", "--to", "8", "--every", "3");
    assertThat(Files.readAllLines(tables.resolve("state-StateInformation.csv")))
        .extracting(line -> line.split(",")[0])
        .containsExactly("time [s]", "2.000000", "5.000000", "8.000000");
    assertThat(tables.resolve("actuation-PercentageCommand.csv")).doesNotExist();
  }

  @Test
  void gpx_run_hasTrackAndReachedGoal() {
    XmlElement gpx = XmlReader.read(exported("--format", "gpx"), "gpx");
    XmlElement goal = gpx.children("wpt").get(0);
    assertThat(goal.children("name").get(0).text()).isEqualTo("<a>");
    assertThat(goal.children("desc").get(0).text()).isEqualTo("reached");
    List<XmlElement> points =
        gpx.children("trk").get(0).children("trkseg").get(0).children("trkpt");
    assertThat(points).hasSize(10);
    assertThat(points.get(9).optionalAttribute("lat")).contains("50.001000000");
    assertThat(points.get(9).children("ele").get(0).text()).isEqualTo("110.000");
    assertThat(points.get(9).children("time").get(0).text()).isEqualTo("2023-11-14T22:13:30Z");
  }

  @Test
  void kml_run_hasATimeForEachPlace() {
    XmlElement document =
        XmlReader.read(exported("--format", "kml"), "kml").children("Document").get(0);
    XmlElement track = document.children("Placemark").get(0).children("gx:Track").get(0);
    assertThat(track.children("when")).hasSize(10);
    assertThat(track.children("gx:coord"))
        .hasSize(10)
        .first()
        .extracting(XmlElement::text)
        .isEqualTo("8.000000000 50.000100000 101.000");
    assertThat(track.children("altitudeMode").get(0).text()).isEqualTo("absolute");
  }

  @Test
  void geojson_run_hasLineAndGoal() throws IOException {
    JsonNode features =
        new ObjectMapper().readTree(exported("--format", "geojson").toFile()).get("features");
    assertThat(features).hasSize(2);
    JsonNode line = features.get(0);
    assertThat(line.at("/geometry/type").asText()).isEqualTo("LineString");
    assertThat(line.at("/geometry/coordinates/9/1").asDouble()).isCloseTo(50.001, within(1e-9));
    assertThat(line.at("/properties/coordTimes")).hasSize(10);
    assertThat(features.get(1).at("/properties/reached").asBoolean()).isTrue();
  }

  @Test
  void map_channelWithoutPlaces_isRefused() {
    assertThat(export("--format", "gpx", "--channel", "actuation")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("actuation").contains("GLOBAL").contains("--channel");
  }

  @Test
  void export_beginsBehindTheEnd_isRefusedWithTheLength() {
    assertThat(export("--format", "csv", "--from", "60")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("--from 60.0").contains("10.0 s");
  }

  /** Reads the messages of the kind {@code state}; what a reader of the format needs, no more. */
  @Test
  void ulog_states_haveTheirNumbersAndNaNWhereAbsent() throws IOException {
    ByteBuffer log =
        ByteBuffer.wrap(Files.readAllBytes(exported("--format", "ulog")))
            .order(ByteOrder.LITTLE_ENDIAN);
    assertThat(log.getLong()).isEqualTo(0x01_35_12_01_67_6f_4c_55L); // "ULog", 01 12 35, version 1
    log.getLong();
    List<String> fields = List.of();
    int states = -1;
    List<Double> latitudes = new ArrayList<>();
    List<Long> times = new ArrayList<>();
    while (log.hasRemaining()) {
      byte[] body = new byte[Short.toUnsignedInt(log.getShort())];
      char type = (char) log.get();
      log.get(body);
      String text = new String(body, StandardCharsets.UTF_8);
      ByteBuffer content = ByteBuffer.wrap(body).order(ByteOrder.LITTLE_ENDIAN);
      if (type == 'F' && text.startsWith("state:uint64_t timestamp;")) {
        fields = List.of(text.substring(text.indexOf(';') + 1).split(";"));
      } else if (type == 'A' && text.endsWith("state") && body.length == 8) {
        states = content.getShort(1);
      } else if (type == 'D' && content.getShort() == states) {
        times.add(content.getLong());
        int y = fields.indexOf("double y");
        latitudes.add(content.getDouble(content.position() + y * Double.BYTES));
      }
    }
    assertThat(latitudes).hasSize(11);
    assertThat(latitudes.get(0)).isNaN();
    assertThat(latitudes.get(10)).isEqualTo(50.001);
    assertThat(times.get(10)).isEqualTo(10_000_000L);
  }

  @Test
  void gpx_stateAndGoalOnAGrid_haveLongitudeAndLatitude() throws IOException {
    Geodetic place = new Geodetic(8.0, 50.0, 0.0);
    ReferenceFrame grid = UtmGrid.frameAt(place);
    Point at = new UtmGrid(grid).grid(place);
    try (McapWriter writer = writer("grid")) {
      write(writer, 0, Channels.STATE, state().referenceFrame(grid).x(at.x()).y(at.y()));
      Waypoint goal = new Waypoint().uid("a").referenceFrame(grid).x(at.x()).y(at.y());
      write(writer, 1, Channels.GOALS, new GoalList().goals(List.of(goal.horizontalThreshold(2))));
    }
    XmlElement gpx = XmlReader.read(exported("--format", "gpx"), "gpx");
    XmlElement fix = gpx.children("trk").get(0).children("trkseg").get(0).children("trkpt").get(0);
    for (XmlElement point : List.of(fix, gpx.children("wpt").get(0))) {
      assertThat(point.optionalAttribute("lon")).contains("8.000000000");
      assertThat(point.optionalAttribute("lat")).contains("50.000000000");
    }
  }
}
