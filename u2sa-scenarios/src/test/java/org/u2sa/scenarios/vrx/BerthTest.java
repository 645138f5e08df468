package org.u2sa.scenarios.vrx;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.scenarios.run.CommandLineRun;

/** A station, a berth, and a berth entered in reverse, in wind, waves and current; by truth. */
class BerthTest {
  private static final double STAYED_S = 5.0;

  /** The last berth of missions/vrx/berths.xml. */
  private static final Geodetic BERTH = new Geodetic(150.6740, -33.7229, 0.0);

  @TempDir private Path folder;

  @Test
  void simulate_berthsInWindAndCurrent_areEnteredWithin20Centimetres() throws IOException {
    Path world = folder.resolve("world.xml");
    Files.writeString(
        world,
        "<world><environment><water><current>0.4</current><towards unit=\"deg\">300</towards>"
            + "<waves><height>0.3</height><period>4</period></waves></water>"
            + "<wind><speed>6</speed><from unit=\"deg\">200</from><gusts>0.5</gusts></wind>"
            + "</environment></world>");
    CommandLineRun run =
        CommandLineRun.of(
            "simulate",
            "../config/vrx/system.xml",
            "--vehicle",
            "../config/vrx/vehicle.xml",
            "--mission",
            "../missions/vrx/berths.xml",
            "--world",
            world.toString(),
            "--port",
            "0",
            "--seed",
            "6",
            "--out",
            folder.resolve("out").toString());

    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    assertThat(Files.readString(folder.resolve("out/summary.json")))
        .contains("\"goalsCompleted\" : 3");
    List<String> track = Files.readAllLines(folder.resolve("out/track.csv"));
    List<String[]> last =
        track.subList(1, track.size()).stream().map(line -> line.split(",")).toList();
    double endS = Double.parseDouble(last.get(last.size() - 1)[0]);
    for (String[] sample : last) {
      if (Double.parseDouble(sample[0]) >= endS - STAYED_S) {
        Geodetic at =
            new Geodetic(Double.parseDouble(sample[1]), Double.parseDouble(sample[2]), 0.0);
        assertThat(at.distanceM(BERTH)).as("at " + sample[0] + " s").isLessThan(0.2);
        assertThat(Double.parseDouble(sample[4])).isBetween(25.0, 35.0);
      }
    }
  }
}
