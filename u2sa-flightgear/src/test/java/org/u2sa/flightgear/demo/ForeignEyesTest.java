package org.u2sa.flightgear.demo;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * A flight seen from outside: Python, with nothing of U2SA, reads what the broker carries; and a
 * program that is told to end leaves its controls neutral and its report written.
 */
@Timeout(90)
class ForeignEyesTest {
  private static final int MESSAGES = 600;

  @TempDir private Path directory;

  @BeforeEach
  void requirePython() throws IOException, InterruptedException {
    boolean able = run("python3", "-c", "import cbor2, paho.mqtt.client").exit() == 0;
    if ("true".equals(System.getenv("CI"))) {
      assertThat(able).as("CI needs python3 with cbor2 and paho-mqtt").isTrue();
    }
    assumeTrue(able, "python3 with cbor2 and paho-mqtt is not here");
  }

  @Test
  void demo_realTime_pythonReadsTheTopicsAndTheEndIsInOrder()
      throws IOException, InterruptedException {
    String port = String.valueOf(freePort());
    Process demo = demo(port);
    try {
      Run python = awaitMessages(port);
      demo.destroy(); // TERM, which is handled like Ctrl-C

      assertThat(python.output())
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
      demo.destroyForcibly();
    }
  }

  private Process demo(String port) throws IOException {
    return new ProcessBuilder(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:+UseSerialGC",
            "-Djava.awt.headless=true",
            "-Du2sa.home=" + CommandLineRun.repository(),
            "-cp",
            System.getProperty("java.class.path"),
            "org.u2sa.gcs.Main",
            "demo",
            "cessna",
            "--realtime",
            "--wind",
            "calm",
            "--port",
            port,
            "--out",
            directory.resolve("out").toString())
        .redirectErrorStream(true)
        .redirectOutput(directory.resolve("demo.txt").toFile())
        .start();
  }

  /** Tries until the broker is there: a virtual machine needs a second or more to start one. */
  private Run awaitMessages(String port) throws IOException, InterruptedException {
    String script = CommandLineRun.repository().resolve("scripts/wire/decode.py").toString();
    while (true) {
      Run python =
          run(
              "python3",
              script,
              "--broker",
              "127.0.0.1:" + port,
              "--count",
              String.valueOf(MESSAGES));
      if (!python.output().contains("no broker at")) {
        return python;
      }
    }
  }

  private static int freePort() throws IOException {
    try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return free.getLocalPort();
    }
  }

  private record Run(int exit, String output) {}

  private static Run run(String... command) throws IOException, InterruptedException {
    try {
      Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
      String output = new String(process.getInputStream().readAllBytes(), UTF_8);
      return new Run(process.waitFor(), output);
    } catch (IOException e) {
      if (command.length > 0 && e.getMessage().startsWith("Cannot run program")) {
        return new Run(127, e.getMessage()); // as a shell answers
      }
      throw e;
    }
  }
}
