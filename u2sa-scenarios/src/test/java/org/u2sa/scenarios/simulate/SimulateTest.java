package org.u2sa.scenarios.simulate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.scenarios.run.CommandLineRun;

/** A user's own vehicle, system file and mission in a folder of their own. */
class SimulateTest {
  @TempDir private Path folder;

  /** Copies a vehicle's project to the folder. */
  private void project(String name) throws IOException, URISyntaxException {
    Path origin = Path.of(SimulateTest.class.getResource(name).toURI());
    try (Stream<Path> files = Files.list(origin)) {
      for (Path each : files.toList()) {
        Files.copy(each, folder.resolve(each.getFileName().toString()));
      }
    }
  }

  private void replace(String file, String what, String by) throws IOException {
    Path path = folder.resolve(file);
    String text = Files.readString(path);
    assertThat(text).contains(what);
    Files.writeString(path, text.replace(what, by));
  }

  private CommandLineRun simulate(String out, String... more) {
    List<String> arguments =
        new ArrayList<>(
            List.of(
                "simulate",
                folder.resolve("system.xml").toString(),
                "--vehicle",
                folder.resolve("vehicle.xml").toString(),
                "--port",
                "0",
                "--out",
                folder.resolve(out).toString()));
    arguments.addAll(List.of(more));
    return CommandLineRun.of(arguments.toArray(new String[0]));
  }

  private JsonNode summary(String out) throws IOException {
    return new com.fasterxml.jackson.databind.ObjectMapper()
        .readTree(Files.readString(folder.resolve(out).resolve("summary.json")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"rover", "wing", "elevator"})
  void simulate_ownVehicle_completesItsMissionAndRepeatsItToTheByte(String name)
      throws IOException, URISyntaxException {
    project(name);
    CommandLineRun first = simulate("one", "--seed", "3");
    CommandLineRun second = simulate("two", "--seed", "3");

    assertThat(first.exitCode()).as(first.out() + first.err()).isEqualTo(ExitCode.DONE);
    assertThat(second.exitCode()).isEqualTo(ExitCode.DONE);
    assertThat(folder.resolve("one/track.csv"))
        .hasSameBinaryContentAs(folder.resolve("two/track.csv"));
    JsonNode summary = summary("one");
    assertThat(summary.get("goals").asInt()).isEqualTo(3);
    assertThat(summary.get("goalsCompleted").asInt()).isEqualTo(3);
    assertThat(summary.get("waypointsCaptured").asInt()).isEqualTo(3);
    assertThat(summary.get("positionErrorRmsM").asDouble()).isBetween(0.001, 1.0);
    assertThat(summary.get("stateWithin3Sigma").asDouble()).isBetween(0.8, 1.0);
    assertThat(folder.resolve("one/logs/Control.log")).exists();
    assertThat(folder.resolve("one/track.svg")).exists();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "GpsSensor | StateEstimator: state lacks x, y: no source of position on sensed-state",
        "FusingStateEstimator | system.xml: no service publishes \"state\"; needed by PathPlanner, Control",
        "WheelMotors | Control: the vehicle does not move, and no service has announced LEFT MOTOR, RIGHT MOTOR",
      })
  void simulate_serviceMissing_saysWhyNoGoalWasCompleted(String service, String reason)
      throws IOException, URISyntaxException {
    project("rover");
    Path system = folder.resolve("system.xml");
    List<String> lines = Files.readAllLines(system);
    assertThat(lines.removeIf(line -> line.contains("." + service + "\""))).isTrue();
    Files.write(system, lines);

    CommandLineRun run = simulate("out", "--limit", "15");

    assertThat(run.exitCode()).isEqualTo(ExitCode.FAILED);
    assertThat(run.out()).contains(reason, "Logs: " + folder.resolve("out/logs"));
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(strings = {"boat", "copter"})
  void simulate_ownVehicleOfMoreKinds_completesItsMissionAndRepeatsItToTheByte(String name)
      throws IOException, URISyntaxException {
    simulate_ownVehicle_completesItsMissionAndRepeatsItToTheByte(name);
  }

  @ParameterizedTest
  @ValueSource(doubles = 10.005)
  void simulate_catapultInACrosswindAndFirstWaypointAbeam_climbsBeforeItTurns(double x)
      throws IOException, URISyntaxException {
    project("wing");
    replace(
        "mission.xml",
        "<waypoint><x>10.0</x><y>54.0027</y>",
        "<waypoint><x>" + x + "</x><y>54.0</y>");
    Files.writeString(
        folder.resolve("world.xml"),
        "<world><environment><wind><speed>5</speed><from unit=\"deg\">90</from></wind></environment></world>");

    CommandLineRun run = simulate("out", "--world", folder.resolve("world.xml").toString());

    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    List<String> track = Files.readAllLines(folder.resolve("out/track.csv"));
    int altitude = List.of(track.get(0).split(",")).indexOf("altitude_m");
    assertThat(track.stream().skip(1))
        .allMatch(row -> Double.parseDouble(row.split(",")[altitude]) > 1.7);
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(doubles = 9.995)
  void simulate_catapultInACrosswindAndFirstWaypointOnTheOtherSide_climbsBeforeItTurns(double x)
      throws IOException, URISyntaxException {
    simulate_catapultInACrosswindAndFirstWaypointAbeam_climbsBeforeItTurns(x);
  }

  @Test
  void simulate_startOfItsOwn_isAtTheAltitudeOfTheHome() throws IOException, URISyntaxException {
    project("copter");
    replace("mission.xml", "<z>0</z>", "<z>43</z>");

    simulate("out", "--start", "10.001,54.001", "--limit", "1");

    List<String> track = Files.readAllLines(folder.resolve("out/track.csv"));
    int altitude = List.of(track.get(0).split(",")).indexOf("altitude_m");
    assertThat(Double.parseDouble(track.get(1).split(",")[altitude])).isBetween(43.0, 44.0);
  }

  @Test
  void simulate_homeInALocalFrame_startsThereAndNotAtTheOrigin()
      throws IOException, URISyntaxException {
    project("rover");
    Files.writeString(
        folder.resolve("mission.xml"),
        "<mission><home><reference>Local NED</reference><x>8</x><y>5</y><psi>180</psi></home>"
            + "<waypoint><reference>Local NED</reference><x>4</x><y>5</y></waypoint></mission>");

    simulate("out", "--limit", "1");

    String[] start = Files.readAllLines(folder.resolve("out/track.csv")).get(1).split(",");
    double metresPerDeg = 6_378_137.0 * Math.PI / 180.0; // at the equator
    assertThat(Double.parseDouble(start[1]) * metresPerDeg).isCloseTo(5.0, within(0.1));
    assertThat(Double.parseDouble(start[2]) * metresPerDeg).isCloseTo(8.0, within(0.1));
  }

  @Test
  void simulate_otherSeed_drivesAnotherTrack() throws IOException, URISyntaxException {
    project("rover");
    simulate("one", "--seed", "3", "--summary-only");
    simulate("two", "--seed", "4", "--summary-only");

    assertThat(summary("one").get("positionErrorRmsM"))
        .isNotEqualTo(summary("two").get("positionErrorRmsM"));
  }

  @Test
  void simulate_objectGoal_isJudgedByItsCompletion() throws IOException, URISyntaxException {
    project("rover");
    replace(
        "system.xml",
        "  <service class=\"org.u2sa.mission",
        "  <service class=\"org.u2sa.world.WorldModeler\" configuration=\"WorldModeler.xml\"/>\n"
            + "  <service class=\"org.u2sa.mission");
    CommandLineRun run = simulate("out", "--mission", folder.resolve("barrel.xml").toString());

    JsonNode summary = summary("out");
    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    assertThat(summary.get("waypoints").asInt()).isEqualTo(1);
    assertThat(summary.get("goals").asInt()).isEqualTo(2);
    assertThat(summary.get("goalsWithoutPlace").asInt()).isEqualTo(1);
    assertThat(summary.get("goalsCompleted").asInt()).isEqualTo(2);
  }

  @Test
  void simulate_objectThatIsNotThere_failsWithTheGoalsName()
      throws IOException, URISyntaxException {
    project("rover");
    CommandLineRun run =
        simulate("out", "--mission", folder.resolve("barrel.xml").toString(), "--limit", "60");

    assertThat(run.exitCode()).isEqualTo(ExitCode.FAILED);
    assertThat(run.out()).contains("goal \"barrel\" was not completed");
  }

  @Test
  void simulate_wallOnTheWay_countsTheContact() throws IOException, URISyntaxException {
    project("rover");
    Files.writeString(
        folder.resolve("world.xml"),
        "<world><reference>Local ENU</reference><box><x>0</x><y>5</y><z>0.5</z><length>0.2</length><width>4</width><height>1</height></box></world>");
    CommandLineRun run = simulate("out", "--world", folder.resolve("world.xml").toString());

    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.FAILED);
    assertThat(summary("out").get("contacts").asInt()).isPositive();
  }

  @ParameterizedTest
  @ValueSource(strings = "OBJECTS")
  void simulate_barrelsSeenByA3dLidarOnly_drivesAroundThemAndUnderABranch(String modeller)
      throws IOException, URISyntaxException {
    project("rover");
    replace(
        "system.xml",
        "  <service class=\"org.u2sa.mission",
        "  <service class=\"org.u2sa.device.PointCloudSensor\"/>\n"
            + "  <service class=\"org.u2sa.world.WorldModeler\" configuration=\"WorldModeler.xml\"/>\n"
            + "  <service class=\"org.u2sa.mission");
    replace(
        "vehicle.xml",
        "</vehicle>",
        "<pointScanner preset=\"Velodyne VLP-16\"><position>0 0 -1</position></pointScanner></vehicle>");
    replace("WorldModeler.xml", "\"WORLD\"", "\"MODELLERS\"");
    replace("WorldModeler.xml", "known.xml", modeller);
    replace(
        "PathPlanner.xml",
        "</configuration>",
        "<variable name=\"PLANNER\" type=\"string\" value=\"GRID\"/></configuration>");
    Path world = folder.resolve("world.xml");
    Files.writeString(
        world,
        "<world>"
            + barrel(10.0, 54.00005, 0.5)
            + barrel(10.0001, 54.0001, 0.5)
            + barrel(10.0002, 54.00005, 3.0)
            + "</world>");

    CommandLineRun run = simulate("out", "--world", world.toString(), "--seed", "5");

    JsonNode summary = summary("out");
    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    assertThat(summary.get("contacts").asInt()).isZero();
    assertThat(summary.get("waypointsCaptured").asInt()).isEqualTo(3);
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(strings = "REACTIVE")
  void simulate_barrelsSeenByA3dLidarOnlyReactive_drivesAroundThemAndUnderABranch(String modeller)
      throws IOException, URISyntaxException {
    simulate_barrelsSeenByA3dLidarOnly_drivesAroundThemAndUnderABranch(modeller);
  }

  private static String barrel(double longitudeDeg, double latitudeDeg, double middleM) {
    return String.format(
        Locale.ROOT,
        "<Cylinder><uid>%s %s</uid><x>%s</x><y>%s</y><z>%s</z><radius>0.4</radius><height>1</height></Cylinder>",
        longitudeDeg,
        latitudeDeg,
        longitudeDeg,
        latitudeDeg,
        middleM);
  }

  @Test
  void simulate_wrongField_isRefusedWithFileLineFieldValueAndExpectation()
      throws IOException, URISyntaxException {
    project("rover");
    replace("vehicle.xml", "<mass unit=\"kg\">35</mass>", "<mass unit=\"kg\">-35</mass>");
    CommandLineRun run = simulate("out");

    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err())
        .contains("vehicle.xml, line 4, <mass>: -35.0 kg: expected above 0 and at most 1.0E9 kg");
  }

  @Test
  void simulate_sensorServiceWithoutASensor_isRefusedWithItsNameAndWhatThereIs()
      throws IOException, URISyntaxException {
    project("rover");
    replace("vehicle.xml", "<gps preset=\"survey\"/>", "");
    CommandLineRun run = simulate("out");

    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err())
        .contains(
            "service \"GpsSensor\" needs a GpsReceiver, which the vehicle lacks; it has <compass>, <imu>, LEFT MOTOR, RIGHT MOTOR");
  }

  @Test
  void check_boat_printsWhatItCanDo() throws IOException, URISyntaxException {
    project("boat");
    CommandLineRun run =
        CommandLineRun.of("vehicle", "check", folder.resolve("vehicle.xml").toString());

    assertThat(run.exitCode()).isEqualTo(ExitCode.DONE);
    assertThat(run.out()).contains("Trio: mass 30.00 kg").contains("turning right:");
  }

  @Test
  void check_massThatNoUndercarriageCarries_isRefusedInWords()
      throws IOException, URISyntaxException {
    project("wing");
    replace("vehicle.xml", "<mass>1.56</mass>", "<mass>1000000</mass>");
    CommandLineRun run =
        CommandLineRun.of("vehicle", "check", folder.resolve("vehicle.xml").toString());

    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err()).contains("vehicle.xml", "cannot be simulated: damping of a tyre");
  }

  @ParameterizedTest
  @ValueSource(strings = "-ackermann")
  void simulate_systemFileOfTheDemo_drivesThroughTheBoardOfTheVehicleFile(String kind)
      throws IOException {
    String config = Path.of("../config/ugv").toString();
    CommandLineRun run =
        CommandLineRun.of(
            "simulate",
            config + "/system" + kind + ".xml",
            "--vehicle",
            config + "/vehicle" + kind + ".xml",
            "--port",
            "0",
            "--out",
            folder.resolve("out").toString());

    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    JsonNode summary = summary("out");
    assertThat(summary.get("waypointsCaptured").asInt()).isEqualTo(6);
    assertThat(summary.get("fenceBreaches").asInt()).isZero();
    assertThat(summary.get("stateWithin3Sigma").asDouble()).isGreaterThan(0.98);
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(strings = "")
  void simulate_usualSystemFileOfTheDemo_drivesThroughTheBoardOfTheVehicleFile(String kind)
      throws IOException {
    simulate_systemFileOfTheDemo_drivesThroughTheBoardOfTheVehicleFile(kind);
  }

  @Test
  void simulate_boardServiceOfAVehicleWithoutABoard_isRefused()
      throws IOException, URISyntaxException {
    project("rover");
    CommandLineRun run =
        CommandLineRun.of(
            "simulate",
            "../config/ugv/system.xml",
            "--vehicle",
            folder.resolve("vehicle.xml").toString(),
            "--out",
            folder.resolve("out").toString());

    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err())
        .contains("vehicle.xml: has no IOIO board, which IoioService needs; expected <ioio>");
  }

  @Test
  void simulate_changeOfTheVehicle_isAnotherVehicle() throws IOException, URISyntaxException {
    project("rover");
    simulate("one", "--summary-only");
    simulate("two", "--summary-only", "--change", "skidSteer/exactMismatch=0.3");
    CommandLineRun wrong = simulate("three", "--change", "body/mass=0");

    assertThat(summary("one").get("crossTrackRmsM"))
        .isNotEqualTo(summary("two").get("crossTrackRmsM"));
    assertThat(wrong.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(wrong.err()).contains("<mass>: 0.0 kg: expected above 0");
  }

  /** An antenna that stands lower than the estimator was told. */
  @Test
  void simulate_wrongAltitude_countsInErrorAndConsistency() throws IOException, URISyntaxException {
    project("wing");
    simulate("sound", "--summary-only");
    CommandLineRun wrong =
        simulate(
            "wrong",
            "--summary-only",
            "--set",
            "FusingStateEstimator:LEVER ARMS=GpsSensor = 0 0 -0.6");

    assertThat(wrong.out())
        .contains("LEVER ARMS has GpsSensor at 0.00 0.00 -0.60, but the vehicle has it at 0.00");

    assertThat(summary("sound").get("altitudeErrorMaxM").asDouble()).isBetween(0.001, 0.2);
    assertThat(summary("wrong").get("altitudeErrorMaxM").asDouble()).isBetween(0.5, 0.9);
    assertThat(summary("wrong").get("stateWithin3Sigma").asDouble())
        .isLessThan(summary("sound").get("stateWithin3Sigma").asDouble() - 0.1);
  }

  /** Wheels that slip, a laser, and nothing else: no GPS, compass or gyroscope. */
  @Test
  void simulate_scanMapWithoutGps_completesItsMissionAndRepeatsItToTheByte()
      throws IOException, URISyntaxException {
    project("indoors");
    String world = folder.resolve("world.xml").toString();
    CommandLineRun first = simulate("one", "--seed", "3", "--world", world);
    CommandLineRun second = simulate("two", "--seed", "3", "--world", world);

    assertThat(first.exitCode()).as(first.out() + first.err()).isEqualTo(ExitCode.DONE);
    assertThat(second.exitCode()).isEqualTo(ExitCode.DONE);
    assertThat(folder.resolve("one/track.csv"))
        .hasSameBinaryContentAs(folder.resolve("two/track.csv"));
    JsonNode summary = summary("one");
    assertThat(summary.get("goalsCompleted").asInt()).isEqualTo(8);
    assertThat(summary.get("positionErrorMaxM").asDouble()).isLessThan(0.3);
    assertThat(summary.get("stateWithin3Sigma").asDouble()).isGreaterThan(0.9);
  }

  @Test
  void simulate_sameWithoutCorrections_missesItsWaypoints() throws IOException, URISyntaxException {
    project("indoors");
    String world = folder.resolve("world.xml").toString();
    CommandLineRun run =
        simulate(
            "out", "--seed", "3", "--world", world, "--set", "WorldModeler:CORRECT STATE=false");

    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.FAILED);
    assertThat(summary("out").get("positionErrorMaxM").asDouble()).isGreaterThan(1.0);
  }
}
