package org.u2sa.scenarios.simulate;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.messages.command.AngleCommand;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.recorder.playback.RecordedMessages;
import org.u2sa.recorder.playback.RecordedSpan;
import org.u2sa.scenarios.run.CommandLineRun;

/** A rover whose gimbal faces the object that it drives to (thesis 3.2.3.8). */
class GimbalRunTest {
  private static final Geodetic BARREL = new Geodetic(10.0002, 54.0001, 0.0);
  private static final double STEP_S = 0.05;

  @TempDir private Path folder;

  private void replace(String file, String what, String by) throws IOException {
    String text = Files.readString(folder.resolve(file));
    assertThat(text).contains(what);
    Files.writeString(folder.resolve(file), text.replace(what, by));
  }

  private void project() throws IOException, URISyntaxException {
    Path origin = Path.of(GimbalRunTest.class.getResource("rover").toURI());
    try (Stream<Path> files = Files.list(origin)) {
      for (Path each : files.toList()) {
        Files.copy(each, folder.resolve(each.getFileName().toString()));
      }
    }
    replace(
        "vehicle.xml",
        "</vehicle>",
        """
        <gimbal>
          <rate>50</rate><pan unit="deg">170</pan><lowestTilt unit="deg">-60</lowestTilt>
          <highestTilt unit="deg">30</highestTilt><maxRate unit="deg/s">180</maxRate><lag>0.05</lag>
        </gimbal>
        </vehicle>
        """);
    replace(
        "system.xml",
        "</system>",
        """
          <service class="org.u2sa.world.WorldModeler" configuration="WorldModeler.xml"/>
          <service class="org.u2sa.control.subsystem.GimbalControl"/>
          <service class="org.u2sa.device.payload.GimbalActuator"/>
        </system>
        """);
    replace("barrel.xml", "<within>2</within>", "<within>2</within><pointed>GIMBAL</pointed>");
  }

  /** Recorded pan angles by time [s]. */
  private TreeMap<Double, Double> pans(Path recording) throws IOException {
    TreeMap<Double, Double> pans = new TreeMap<>();
    try (RecordedMessages messages = RecordedMessages.open(recording)) {
      messages.forEach(
          messages.channels(List.of("actuation")),
          RecordedSpan.all(messages.reader()),
          (topic, message, nanos) -> {
            if (message instanceof AngleCommand angle && angle.actuatorName().equals("PAN")) {
              pans.put(nanos * 1e-9, angle.angle());
            }
          });
    }
    return pans;
  }

  @Test
  void simulate_objectGoalThatPointsTheGimbal_keepsItOnTheObject()
      throws IOException, URISyntaxException {
    project();
    Path out = folder.resolve("out");

    CommandLineRun run =
        CommandLineRun.of(
            "simulate",
            folder.resolve("system.xml").toString(),
            "--vehicle",
            folder.resolve("vehicle.xml").toString(),
            "--mission",
            folder.resolve("barrel.xml").toString(),
            "--port",
            "0",
            "--record",
            "--out",
            out.toString());

    assertThat(run.exitCode()).as(run.said()).isEqualTo(ExitCode.DONE);
    TreeMap<Double, Double> pans = pans(out.resolve("recording.mcap"));
    assertThat(pans).hasSizeGreaterThan(20);
    int compared = 0;
    double turned = 0.0;
    List<String> track = Files.readAllLines(out.resolve("track.csv"));
    for (String line : track.subList(1, track.size())) {
      String[] fields = line.split(",");
      double time = Double.parseDouble(fields[0]);
      if (pans.floorKey(time) == null || pans.floorKey(time) < time - STEP_S) {
        continue; // not pointed at that time
      }
      Point ned =
          new Geodetic(Double.parseDouble(fields[1]), Double.parseDouble(fields[2]), 0.0)
              .nedOf(BARREL);
      double right = Math.atan2(ned.y(), ned.x()) - Math.toRadians(Double.parseDouble(fields[4]));
      double off = Math.IEEEremainder(pans.floorEntry(time).getValue() + right, 2.0 * Math.PI);
      assertThat(Math.toDegrees(off)).as("pan at %s s", time).isBetween(-6.0, 6.0);
      turned = Math.max(turned, Math.abs(right));
      compared++;
    }
    assertThat(compared).isGreaterThan(20);
    assertThat(Math.toDegrees(turned)).as("the object was aside").isGreaterThan(30.0);
  }
}
