package org.u2sa.scenarios.roboboat.subvehicle;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.scenarios.run.CommandLineRun;
import org.u2sa.testkit.Repository;

/** The sub-vehicle's system on its own fetches the puck of its mission, scored by the truth. */
class FetchFlightTest {
  private static final Geodetic DECK = new Geodetic(10.0, 54.0, 0.0);
  private static final Geodetic PUCK = new Geodetic(10.00003, 54.00002, 0.0);
  private static final double PUCK_ALTITUDE_M = 0.25;

  @TempDir private Path folder;

  /** A row of the track. */
  private static final class Row {
    private final Geodetic place;
    private final double altitudeM;

    Row(String line) {
      String[] fields = line.split(",", -1);
      place = new Geodetic(Double.parseDouble(fields[1]), Double.parseDouble(fields[2]), 0.0);
      altitudeM = Double.parseDouble(fields[3]);
    }

    double from(Geodetic other) {
      Point ned = place.nedOf(other);
      return Math.hypot(ned.x(), ned.y());
    }
  }

  @Test
  void simulate_windOf6MetresPerSecond_gripsThePuckAndLandsOnTheDeck() throws IOException {
    Path world = folder.resolve("world.xml");
    Files.writeString(
        world,
        "<world><reference>Local ENU</reference><environment><wind><speed>6</speed>"
            + "<from unit=\"deg\">230</from><gusts>0.5</gusts></wind></environment></world>");
    Path own = Repository.root().resolve("config/roboboat/quadrotor");
    CommandLineRun run =
        CommandLineRun.of(
            "simulate",
            own.resolve("system.xml").toString(),
            "--vehicle",
            own.resolve("vehicle.xml").toString(),
            "--world",
            world.toString(),
            "--seed",
            "41",
            "--limit",
            "120",
            "--port",
            "0",
            "--out",
            folder.resolve("out").toString());

    assertThat(run.exitCode()).as(run.out() + run.err()).isZero();
    List<String> lines = Files.readAllLines(folder.resolve("out/track.csv"));
    long atPuck =
        lines.stream()
            .skip(1)
            .map(Row::new)
            .filter(row -> row.from(PUCK) < 0.3 && row.altitudeM - PUCK_ALTITUDE_M < 0.15)
            .count();
    Row end = new Row(lines.get(lines.size() - 1));
    assertThat(atPuck).isGreaterThan(30); // 20 a second
    assertThat(end.from(DECK)).isLessThan(0.5);
    assertThat(end.altitudeM).isLessThan(0.3);
  }
}
