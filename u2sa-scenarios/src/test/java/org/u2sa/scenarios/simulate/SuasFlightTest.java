package org.u2sa.scenarios.simulate;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.scenarios.run.CommandLineRun;
import org.u2sa.testkit.Repository;

/** The aircraft of config/suas in wind with Dryden gusts, scored by the track of the truth. */
class SuasFlightTest {
  private static final double TAKES_OFF_M = 43.28; // altitude of the field
  private static final Geodetic FIELD = new Geodetic(-76.55578, 38.31633, 0.0);

  @TempDir private Path folder;

  private record Row(
      double timeS, Point ned, double altitudeM, double headingRad, double speedMps, int leg) {
    static Row of(String line) {
      String[] fields = line.split(",", -1);
      Geodetic place =
          new Geodetic(Double.parseDouble(fields[1]), Double.parseDouble(fields[2]), 0.0);
      return new Row(
          Double.parseDouble(fields[0]),
          FIELD.nedOf(place),
          Double.parseDouble(fields[3]),
          Math.toRadians(Double.parseDouble(fields[4])),
          Double.parseDouble(fields[5]),
          Integer.parseInt(fields[7]));
    }

    double fromM(double north, double east) {
      return Math.hypot(ned.x() - north, ned.y() - east);
    }
  }

  private List<Row> fly(
      String aircraft, String vehicle, String goals, double windMps, long seed, String... more)
      throws IOException {
    Path world = folder.resolve("world.xml");
    Files.writeString(
        world,
        "<world><environment><wind><speed>"
            + windMps
            + "</speed><from unit=\"deg\">150</from><shear>true</shear></wind></environment></world>");
    Path mission = folder.resolve("mission.xml");
    Files.writeString(
        mission,
        "<mission><home><x>-76.55578</x><y>38.31633</y><z>43.28</z><psi>100</psi></home>"
            + goals
            + "</mission>");
    Path own = Repository.root().resolve("config/suas").resolve(aircraft);
    List<String> arguments =
        new ArrayList<>(
            List.of(
                "simulate",
                own.resolve("system.xml").toString(),
                "--vehicle",
                own.resolve(vehicle).toString(),
                "--mission",
                mission.toString(),
                "--world",
                world.toString(),
                "--seed",
                Long.toString(seed),
                "--limit",
                "500",
                "--port",
                "0",
                "--out",
                folder.resolve("out").toString()));
    arguments.addAll(List.of(more));
    CommandLineRun run = CommandLineRun.of(arguments.toArray(new String[0]));
    assertThat(run.exitCode()).as(run.out() + run.err()).isZero();
    return Files.readAllLines(folder.resolve("out/track.csv")).stream()
        .skip(1)
        .map(Row::of)
        .toList();
  }

  private static String place(String element, double north, double east, double up, String more) {
    Geodetic at = FIELD.fromNed(Point.of(north, east, 0.0));
    return "<"
        + element
        + "><x>"
        + at.longitudeDeg()
        + "</x><y>"
        + at.latitudeDeg()
        + "</y><z>"
        + (TAKES_OFF_M + up)
        + "</z>"
        + more
        + "</"
        + element
        + ">";
  }

  /** RMS distance from a leg along a meridian, between two norths. */
  private static double acrossRmsM(
      List<Row> rows, int leg, double fromNorth, double toNorth, double east) {
    return Math.sqrt(
        rows.stream()
            .filter(row -> row.leg() == leg)
            .filter(row -> row.ned().x() > fromNorth && row.ned().x() < toNorth)
            .mapToDouble(row -> Math.pow(row.ned().y() - east, 2))
            .average()
            .orElseThrow());
  }

  /** Take-off from the runway at 100 degrees, two long legs across and along the wind, landing. */
  @ParameterizedTest
  @CsvSource({"5, 22, 5.0, 2.0"})
  void plane_runwayWaypointsRunway_keepsToItsLines(
      double windMps, long seed, double acrossM, double offCentrelineM) throws IOException {
    List<Row> rows =
        fly(
            "plane",
            "vehicle.xml",
            "<takeOff><z>83</z></takeOff>"
                + place("waypoint", -400, 500, 80, "")
                + place("waypoint", 600, 500, 80, "")
                + place("waypoint", 600, -500, 80, "")
                + place("waypoint", -400, -500, 80, "")
                + place(
                    "landing",
                    0,
                    0,
                    0,
                    "<psi unit=\"deg\">100</psi><speed>18</speed><horizontalThreshold>30</horizontalThreshold>"),
            windMps,
            seed);

    for (double[] corner : new double[][] {{-400, 500}, {600, 500}, {600, -500}, {-400, -500}}) {
      assertThat(
              rows.stream().mapToDouble(row -> row.fromM(corner[0], corner[1])).min().orElseThrow())
          .as("waypoint at %s, %s", corner[0], corner[1])
          .isLessThan(15.2);
    }
    assertThat(acrossRmsM(rows, 1, -100, 550, 500)).isLessThan(acrossM);
    assertThat(acrossRmsM(rows, 3, -350, 300, -500)).isLessThan(acrossM);
    Row end = rows.get(rows.size() - 1);
    double offRunwayM =
        end.ned().y() * Math.cos(Math.toRadians(100))
            - end.ned().x() * Math.sin(Math.toRadians(100));
    assertThat(Math.abs(offRunwayM)).isLessThan(offCentrelineM);
    assertThat(end.fromM(0, 0)).isLessThan(200.0);
    assertThat(end.speedMps()).isLessThan(0.3);
    assertThat(end.altitudeM()).isLessThan(TAKES_OFF_M + 0.5);
  }

  @Tag("long")
  @ParameterizedTest
  @CsvSource({"8, 23, 10.0, 2.0"})
  void plane_runwayWaypointsRunwayInMoreWind_keepsToItsLines(
      double windMps, long seed, double acrossM, double offCentrelineM) throws IOException {
    plane_runwayWaypointsRunway_keepsToItsLines(windMps, seed, acrossM, offCentrelineM);
  }

  /** Two turns counter-clockwise in mid-mission, then to the next waypoint; 8 s of calculation. */
  @Test
  void plane_circlesInWind_keepsToTheCircleAndLeavesTowardsTheNextGoal() throws IOException {
    List<Row> rows =
        fly(
            "plane",
            "vehicle.xml",
            "<takeOff><z>83</z></takeOff>"
                + place(
                    "station",
                    0,
                    500,
                    60,
                    "<turns>1.5</turns><radius>-120</radius><towardsNext>true</towardsNext>")
                + place("waypoint", 600, 500, 60, ""),
            5.0,
            24);

    List<Double> offs =
        rows.stream()
            .filter(row -> row.timeS() > 45.0 && row.timeS() < 85.0)
            .map(row -> row.fromM(0, 500) - 120.0)
            .toList();
    assertThat(Math.sqrt(offs.stream().mapToDouble(off -> off * off).average().orElseThrow()))
        .isLessThan(5.0);
    assertThat(rows.stream().mapToDouble(row -> row.fromM(600, 500)).min().orElseThrow())
        .isLessThan(15.2);
  }

  /** Along 120 m, sideways, with its nose on a place 60 m beside. */
  @Test
  void hexacopter_lookAt_keepsItsNoseOnThePlace() throws IOException {
    Geodetic view = FIELD.fromNed(Point.of(60.0, 120.0, 0.0));
    String lookAt =
        "<lookAt>"
            + view.longitudeDeg()
            + " "
            + view.latitudeDeg()
            + " "
            + TAKES_OFF_M
            + "</lookAt>";
    List<Row> rows =
        fly(
            "hexacopter",
            "vehicle.xml",
            "<takeOff><z>83</z></takeOff>"
                + place("waypoint", 0, 60, 40, lookAt)
                + place("waypoint", 120, 60, 40, lookAt),
            5.0,
            43);

    List<Double> offs =
        rows.stream()
            .filter(row -> row.leg() == 1)
            .map(row -> Math.atan2(120.0 - row.ned().y(), 60.0 - row.ned().x()) - row.headingRad())
            .map(off -> Math.abs(Math.toDegrees(Math.IEEEremainder(off, 2.0 * Math.PI))))
            .toList();
    assertThat(offs).hasSizeGreaterThan(100).allMatch(off -> off < 15.0);
  }

  @Test
  void plane_thrownWithoutLandingGear_landsOnItsBellyAgainstTheWind() throws IOException {
    List<Row> rows =
        fly(
            "plane",
            "vehicle-belly.xml",
            "<takeOff><z>83</z></takeOff>"
                + place("waypoint", 300, 500, 60, "")
                + place(
                    "landing",
                    0,
                    0,
                    0,
                    "<speed>18</speed><horizontalThreshold>60</horizontalThreshold>"),
            5.0,
            31,
            "--set",
            "CessnaControl:START HEIGHT=1.2");

    Row end = rows.get(rows.size() - 1);
    assertThat(end.fromM(0, 0)).isLessThan(80.0);
    assertThat(end.speedMps()).isLessThan(0.3);
    assertThat(end.altitudeM()).isLessThan(TAKES_OFF_M + 0.5);
  }

  @ParameterizedTest
  @CsvSource({"hexacopter, 41", "quadcopter, 42"})
  void multirotor_takeOffWaypointsLanding_keepsToItsLines(String aircraft, long seed)
      throws IOException {
    List<Row> rows =
        fly(
            aircraft,
            "vehicle.xml",
            "<takeOff><z>93</z></takeOff>"
                + place("waypoint", 0, 60, 50, "")
                + place("waypoint", 150, 60, 50, "")
                + place("landing", 20, 0, 0, ""),
            5.0,
            seed);

    assertThat(acrossRmsM(rows, 1, 5, 145, 60)).isLessThan(0.5);
    Row end = rows.get(rows.size() - 1);
    assertThat(end.fromM(20, 0)).isLessThan(1.0);
    assertThat(end.altitudeM()).isLessThan(TAKES_OFF_M + 0.5);
  }

  /** Nearest distance from an aircraft without a transponder that comes down the leg [m]. */
  private double nearestM(boolean hasRadar) throws IOException {
    Path own = Repository.root().resolve("config/suas/plane");
    String radar =
        hasRadar
            ? "<service class=\"org.u2sa.device.RadarSensor\" configuration=\"RadarSensor.xml\"/>"
            : "";
    Path system = folder.resolve("system.xml");
    Files.writeString(
        system,
        Files.readString(own.resolve("system-competition.xml"))
            .replaceFirst("<service class=\"[^\"]*SurveyCamera\"[^>]*>", radar)
            .replace("configuration=\"", "configuration=\"" + own + "/"));
    Path world = folder.resolve("silent.xml");
    Geodetic from = FIELD.fromNed(Point.of(1500.0, 0.0, 0.0));
    Geodetic to = FIELD.fromNed(Point.of(-500.0, 0.0, 0.0));
    String at = "<referenceFrame>Global</referenceFrame><x>%.7f</x><y>%.7f</y><z>%.1f</z>";
    Files.writeString(
        world,
        "<world><mover><sphere><uid>silent</uid>"
            + String.format(at, from.longitudeDeg(), from.latitudeDeg(), TAKES_OFF_M + 90.0)
            + "<radius>2</radius></sphere><waypoint>"
            + String.format("<x>%.7f</x><y>%.7f</y>", to.longitudeDeg(), to.latitudeDeg())
            + "</waypoint><speed>20</speed></mover></world>");
    Path mission = folder.resolve("north.xml");
    Files.writeString(
        mission,
        "<mission><home><x>-76.55578</x><y>38.31633</y><z>43.28</z><psi>0</psi></home>"
            + place("takeOff", 200.0, 0.0, 60.0, "")
            + place("waypoint", 1300.0, 0.0, 90.0, "")
            + "</mission>");
    Path out = folder.resolve(hasRadar ? "radar" : "blind");
    CommandLineRun run =
        CommandLineRun.of(
            "simulate",
            system.toString(),
            "--vehicle",
            own.resolve("vehicle.xml").toString(),
            "--mission",
            mission.toString(),
            "--world",
            world.toString(),
            "--seed",
            "5",
            "--limit",
            "55",
            "--port",
            "0",
            "--out",
            out.toString());
    assertThat(run.exitCode()).as(run.out() + run.err()).isNotEqualTo(2);
    double nearest = Double.POSITIVE_INFINITY;
    for (String line : Files.readAllLines(out.resolve("track.csv")).stream().skip(1).toList()) {
      double timeS = Double.parseDouble(line.substring(0, line.indexOf(',')));
      Row row = Row.of(line);
      double north = row.ned().x() - (1500.0 - 20.0 * timeS);
      double up = row.altitudeM() - TAKES_OFF_M - 90.0;
      nearest = Math.min(nearest, Math.hypot(Math.hypot(north, row.ned().y()), up));
    }
    return nearest;
  }

  @Test
  void plane_aircraftWithoutTransponder_keepsItsDistanceOnlyWithRadar() throws IOException {
    assertThat(nearestM(false)).isLessThan(50.0);
    assertThat(nearestM(true)).isGreaterThan(50.0);
  }
}
