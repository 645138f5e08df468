package org.u2sa.scenarios.simulate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.scenarios.run.CommandLineRun;

/** Movers, zones and waves of a world file, from the file to the summary of {@code simulate}. */
class WorldFileRunTest {
  @TempDir private Path folder;

  private CommandLineRun simulate(String vehicle, String world, String out)
      throws IOException, URISyntaxException {
    Path origin = Path.of(SimulateTest.class.getResource(vehicle).toURI());
    try (Stream<Path> files = Files.list(origin)) {
      for (Path each : files.toList()) {
        Path to = folder.resolve(each.getFileName().toString());
        Files.deleteIfExists(to);
        Files.copy(each, to);
      }
    }
    Files.writeString(folder.resolve("world.xml"), world);
    return CommandLineRun.of(
        "simulate",
        folder.resolve("system.xml").toString(),
        "--vehicle",
        folder.resolve("vehicle.xml").toString(),
        "--world",
        folder.resolve("world.xml").toString(),
        "--port",
        "0",
        "--out",
        folder.resolve(out).toString());
  }

  private JsonNode summary(String out) throws IOException {
    return new ObjectMapper()
        .readTree(Files.readString(folder.resolve(out).resolve("summary.json")));
  }

  private static String mover(double east, double delayS) {
    return String.format(
        Locale.ROOT,
        """
        <world>
          <reference>Local ENU</reference>
          <mover>
            <cylinder><uid>walker</uid><x>%f</x><y>5</y><z>0.9</z><radius>0.4</radius><height>1.8</height></cylinder>
            <waypoint><x>%f</x><y>5</y></waypoint>
            <speed>1.2</speed>
            <delay>%f</delay>
            <end>return</end>
          </mover>
        </world>
        """,
        east,
        -east,
        delayS);
  }

  @Test
  void simulate_moverAcrossTheWay_isTouchedTheSameWayEveryTime()
      throws IOException, URISyntaxException {
    CommandLineRun first = simulate("rover", mover(0.6, 0.0), "one");
    simulate("rover", mover(0.6, 0.0), "two");

    assertThat(summary("one").get("contacts").asInt()).as(first.out() + first.err()).isPositive();
    assertThat(summary("two").get("contacts")).isEqualTo(summary("one").get("contacts"));
    assertThat(folder.resolve("one/track.csv"))
        .hasSameBinaryContentAs(folder.resolve("two/track.csv"));
    JsonNode walker = summary("one").get("obstacles").get(0);
    assertThat(walker.get("name").asText()).isEqualTo("walker");
    assertThat(walker.get("moves").asBoolean()).isTrue();
    assertThat(Files.readString(folder.resolve("one/track.svg"))).contains("walker");
  }

  @Test
  void simulate_moverThatWaitsAside_isNotTouched() throws IOException, URISyntaxException {
    CommandLineRun run = simulate("rover", mover(60.0, 10_000.0), "out");

    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    assertThat(summary("out").get("contacts").asInt()).isZero();
  }

  /** The rover drives north along x = 0; the circle around the box covers its way. */
  @Test
  void simulate_longBoxThatPassesBeside_isNoContactAndNoViolation()
      throws IOException, URISyntaxException {
    CommandLineRun run =
        simulate(
            "rover",
            """
            <world>
              <reference>Local ENU</reference>
              <mover>
                <box><uid>train</uid><x>1.5</x><y>5</y><z>0.5</z><length>6</length><width>0.5</width><height>1</height></box>
                <waypoint><x>1.5</x><y>8</y></waypoint>
                <speed>0.01</speed>
                <end>return</end>
              </mover>
            </world>
            """,
            "out");

    assertThat(summary("out").get("contacts").asInt()).isZero();
    assertThat(summary("out").get("obstacles").get(0).get("name").asText()).isEqualTo("train");
    assertThat(summary("out").get("obstacles").get(0).get("leastDistanceM").asDouble()).isZero();
    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
  }

  @Test
  void simulate_zones_reportsEntriesAndRefusesKeepOut() throws IOException, URISyntaxException {
    String world =
        """
        <world>
          <reference>Local ENU</reference>
          <zone>
            <polygon><uid>sand</uid><points>-3 3; 3 3; 3 7; -3 7</points></polygon>
            <surface><grip>0.5</grip><rollingResistance>0.1</rollingResistance></surface>
          </zone>
          <zone><kind>KIND</kind><polygon><uid>bed</uid><points>5 8; 9 8; 9 14; 5 14</points></polygon></zone>
        </world>
        """;
    CommandLineRun judged = simulate("rover", world.replace("KIND", "judge"), "one");
    CommandLineRun kept = simulate("rover", world.replace("KIND", "keep-out"), "two");

    assertThat(judged.exitCode()).as(judged.out() + judged.err()).isEqualTo(ExitCode.DONE);
    JsonNode summary = summary("one");
    assertThat(summary.get("zone sand entries").asInt()).isEqualTo(1);
    assertThat(summary.get("zone sand exits").asInt()).isEqualTo(1);
    assertThat(summary.get("zone sand seconds").asDouble()).isBetween(2.0, 20.0);
    assertThat(summary.get("zone bed entries").asInt()).isEqualTo(1);
    assertThat(Files.readString(folder.resolve("one/track.svg")))
        .contains(">bed<")
        .doesNotContain(">sand<");
    assertThat(kept.exitCode()).isEqualTo(ExitCode.FAILED);
    assertThat(kept.out()).contains("keep-out zone \"bed\" was entered at");
  }

  @Test
  void simulate_boatInWaves_rollsButArrives() throws IOException, URISyntaxException {
    CommandLineRun run =
        simulate(
            "boat",
            """
            <world>
              <environment>
                <water>
                  <waves><height>0.2</height><period>3</period><towards unit="deg">90</towards></waves>
                </water>
              </environment>
            </world>
            """,
            "out");

    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    assertThat(summary("out").get("waypointsCaptured").asInt()).isEqualTo(3);
    List<String> track = Files.readAllLines(folder.resolve("out/track.csv"));
    int column = List.of(track.get(0).split(",")).indexOf(altitude(track.get(0)));
    double[] up =
        track.stream()
            .skip(1)
            .mapToDouble(line -> Double.parseDouble(line.split(",")[column]))
            .toArray();
    double squares = 0.0;
    for (double each : up) {
      squares += each * each;
    }
    assertThat(4.0 * Math.sqrt(squares / up.length)).isCloseTo(0.2, within(0.06));
  }

  private static String altitude(String header) {
    return Stream.of(header.split(","))
        .filter(name -> name.startsWith("altitude"))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void check_everything_isListed() throws IOException {
    Path file = folder.resolve("world.xml");
    Files.writeString(
        file,
        mover(2.0, 0.0)
            .replace(
                "</world>",
                "<zone><polygon><uid>bed</uid><points>5 8; 9 8; 9 14</points></polygon></zone></world>"));
    CommandLineRun run = CommandLineRun.of("world", "check", file.toString());

    assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.DONE);
    assertThat(run.out())
        .contains("mover walker, 2 legs in 6.7 s, repeated")
        .contains("zone bed: judge of 3 corners");
  }
}
