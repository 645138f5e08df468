package org.u2sa.scenarios.simulate;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.scenarios.run.CommandLineRun;
import org.u2sa.testkit.Repository;

/** Devices of the aircraft of config/suas fail in flight; scored by the track of the truth. */
class AircraftFaultTest {
  @TempDir private Path folder;

  private record Row(double timeS, double altitudeM, double speedMps) {
    static Row of(String line) {
      String[] fields = line.split(",", -1);
      return new Row(
          Double.parseDouble(fields[0]),
          Double.parseDouble(fields[3]),
          Double.parseDouble(fields[5]));
    }
  }

  private List<Row> fly(String aircraft, String mission, int limitS, String fault)
      throws IOException {
    Path file = folder.resolve("mission.xml");
    Files.writeString(
        file,
        "<mission><home><x>-76.55578</x><y>38.31633</y><z>43.28</z><psi>100</psi></home>"
            + mission
            + "</mission>");
    Path own = Repository.root().resolve("config/suas").resolve(aircraft);
    List<String> arguments =
        new ArrayList<>(
            List.of(
                "simulate", own.resolve("system.xml").toString(), "--port", "0", "--seed", "5"));
    arguments.addAll(List.of("--vehicle", own.resolve("vehicle.xml").toString()));
    arguments.addAll(List.of("--mission", file.toString(), "--limit", String.valueOf(limitS)));
    arguments.addAll(List.of("--change", fault, "--out", folder.resolve("out").toString()));
    CommandLineRun run = CommandLineRun.of(arguments.toArray(new String[0]));
    assertThat(run.exitCode()).as(run.out() + run.err()).isLessThan(2);
    return Files.readAllLines(folder.resolve("out/track.csv")).stream()
        .skip(1)
        .map(Row::of)
        .toList();
  }

  private String log(String service) throws IOException {
    return Files.readString(folder.resolve("out/logs").resolve(service + ".log"));
  }

  @Test
  void plane_receiverLost_circlesNearItsAltitudeByTheBarometer() throws IOException {
    List<Row> rows =
        fly(
            "plane",
            "<takeOff><z>103</z></takeOff>"
                + "<waypoint><x>-76.5400</x><y>38.3163</y><z>123</z></waypoint>"
                + "<station><x>-76.5450</x><y>38.3163</y><z>123</z></station>",
            200,
            "gps/failsAt=50");

    assertThat(log("SafetyManager")).contains("failsafe HOLD because of [position");
    List<Row> after = rows.stream().filter(row -> row.timeS() > 140.0).toList();
    assertThat(after).hasSizeGreaterThan(100);
    assertThat(after).allMatch(row -> Math.abs(row.altitudeM() - 115.0) < 25.0);
    assertThat(after).allMatch(row -> row.speedMps() > 10.0);
  }

  /** Its velocity then follows from the specific force and the measured tilt. */
  @Test
  void quadcopter_receiverLost_staysUpAndGoesOn() throws IOException {
    List<Row> rows =
        fly(
            "quadcopter",
            "<takeOff><z>63</z></takeOff>"
                + "<waypoint><x>-76.5555</x><y>38.3166</y><z>63</z></waypoint>"
                + "<station><x>-76.5555</x><y>38.3166</y><z>63</z><horizontalThreshold>3</horizontalThreshold></station>",
            70,
            "gps/failsAt=20");

    List<Row> after = rows.stream().filter(row -> row.timeS() > 30.0).toList();
    assertThat(after).hasSizeGreaterThan(500);
    assertThat(after).allMatch(row -> Math.abs(row.altitudeM() - 63.0) < 5.0);
    assertThat(after).allMatch(row -> row.speedMps() < 1.5);
  }

  @Test
  void plane_pitotTubeLost_finishesItsMission() throws IOException {
    fly(
        "plane",
        "<takeOff><z>103</z></takeOff>"
            + "<waypoint><name>a</name><x>-76.5500</x><y>38.3127</y><z>123</z></waypoint>"
            + "<waypoint><name>b</name><x>-76.5500</x><y>38.3217</y><z>123</z></waypoint>",
        150,
        "pitotTube/failsAt=30");

    assertThat(log("AirspeedSensor")).contains("the pitot tube is lost");
    assertThat(log("PathPlanner")).contains("goal \"b\" reached");
  }

  /**
   * Blocked, it would read nothing after a descent of 17 m, and the aircraft would dive; in the
   * climb-out it reads more with each metre, and the aircraft would not climb on.
   */
  @ParameterizedTest
  @ValueSource(ints = {10, 60})
  void plane_pitotTubeBlocked_landsByGroundSpeedAndWind(int blockedAtS) throws IOException {
    List<Row> rows =
        fly(
            "plane",
            "<takeOff><z>103</z></takeOff>"
                + "<waypoint><x>-76.5650</x><y>38.3163</y><z>143</z></waypoint>"
                + "<landing><x>-76.55578</x><y>38.31633</y><z>43.28</z><psi unit=\"deg\">100</psi></landing>",
            300,
            "pitotTube/blockedAt=" + blockedAtS);

    assertThat(log("StateEstimator")).contains("AirspeedSensor contradicts ground speed and wind");
    assertThat(log("StateEstimator")).doesNotContain("AirspeedSensor agrees");
    assertThat(log("PathPlanner")).contains("stands");
    Row end = rows.get(rows.size() - 1);
    assertThat(end.altitudeM()).isLessThan(45.0);
    assertThat(end.speedMps()).isLessThan(0.3);
  }

  @Test
  void hexacopter_rotorOneDead_finishesItsMissionAndLands() throws IOException {
    List<Row> rows =
        fly(
            "hexacopter",
            "<takeOff><z>73</z></takeOff>"
                + "<waypoint><x>-76.5555</x><y>38.3166</y><z>73</z></waypoint>"
                + "<landing><x>-76.55578</x><y>38.31633</y><z>43.28</z></landing>",
            120,
            "multirotor/rotor/failsAt=8");

    assertThat(log("Control")).contains("lost: ROTOR 1");
    assertThat(log("PathPlanner")).contains("stands");
    Row end = rows.get(rows.size() - 1);
    assertThat(end.altitudeM()).isLessThan(44.0);
    assertThat(end.speedMps()).isLessThan(0.3);
  }
}
