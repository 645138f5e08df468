package org.u2sa.scenarios.cessna;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.scenarios.run.ForeignProgram;
import org.u2sa.testkit.FreePort;
import org.u2sa.testkit.NeedsProgram;
import org.u2sa.testkit.ProcessTree;
import org.u2sa.testkit.Repository;

/**
 * A flight seen from outside: Python, with nothing of U2SA, reads what the broker carries; and a
 * program that is told to end leaves its controls neutral and its report written.
 */
@Timeout(90)
@NeedsProgram(
    value = "python3",
    modules = {"cbor2", "paho.mqtt.client"})
class ForeignEyesTest {
  private static final int MESSAGES = 600;

  @TempDir private Path directory;

  @Test
  void demo_realTime_pythonReadsTheTopicsAndTheEndIsInOrder()
      throws IOException, InterruptedException {
    String python = ForeignProgram.python();
    String port = String.valueOf(FreePort.find());
    Process demo = demo(port);
    try {
      ForeignProgram.Ended read = awaitMessages(python, port);
      demo.destroy(); // TERM, which is handled like Ctrl-C

      assertThat(read.output())
          .contains("cessna/sensed-state AircraftState {")
          .contains("cessna/state AircraftState {")
          .contains("cessna/goals GoalList {")
          .contains("cessna/navigation NavigationPoint {")
          .contains("cessna/actuation PercentageCommand {")
          .contains("cessna/health HealthReport {")
          .contains("\"actuatorName\": \"AILERON\"")
          .doesNotContain("are no message");
      assertThat(demo.waitFor(30, TimeUnit.SECONDS)).isTrue();
      assertThat(demo.exitValue()).as("128 + TERM").isEqualTo(143);
      assertThat(Summary.in(directory.resolve("out")).number("waypointsCaptured")).isZero();
      for (String service :
          new String[] {"Control", "PathPlanner", "MissionManager", "Simulator"}) {
        assertThat(directory.resolve("out/logs/" + service + ".log"))
            .content(UTF_8)
            .contains("ended: STOPPED");
      }
    } finally {
      ProcessTree.kill(demo);
    }
  }

  private Process demo(String port) throws IOException {
    return ForeignProgram.u2sa(
        directory.resolve("demo.txt"),
        "demo",
        "cessna",
        "--realtime",
        "--wind",
        "calm",
        "--port",
        port,
        "--out",
        directory.resolve("out").toString());
  }

  /** Tries until the broker is there: a virtual machine needs a second or more to start one. */
  private ForeignProgram.Ended awaitMessages(String python, String port)
      throws IOException, InterruptedException {
    String script = Repository.root().resolve("scripts/wire/decode.py").toString();
    while (true) {
      ForeignProgram.Ended read =
          ForeignProgram.run(
              python, script, "--broker", "127.0.0.1:" + port, "--count", String.valueOf(MESSAGES));
      if (!read.output().contains("no broker at")) {
        return read;
      }
    }
  }
}
