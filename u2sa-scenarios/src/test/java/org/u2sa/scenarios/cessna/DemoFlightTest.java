package org.u2sa.scenarios.cessna;

import static org.assertj.core.api.Assertions.as;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.InstanceOfAssertFactories.STRING;

import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.scenarios.run.CommandLineRun;

/** Whole flights by the command line, own take-off included, as fast as the machine allows. */
class DemoFlightTest {
  private static final int CONFIGURED_PORT = 1883;

  @TempDir private Path directory;

  @ParameterizedTest(name = "seed {0}, wind {1}")
  @CsvSource({"2, 8@200"})
  void demo_tenWaypoints_keepsAllBounds(long seed, String wind) {
    CommandLineRun run = fly("out", "--seed", String.valueOf(seed), "--wind", wind);

    assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.DONE);
    Summary summary = Summary.in(directory.resolve("out"));
    summary.requireGood();
    assertThat(summary.number("waypoints")).isEqualTo(10.0);
    assertThat(summary.number("seed")).isEqualTo(seed);
  }

  @Tag("long")
  @ParameterizedTest(name = "seed {0}, wind {1}")
  @CsvSource({"1, calm", "3, 8@20"})
  void demo_tenWaypointsInOtherWinds_keepsAllBounds(long seed, String wind) {
    demo_tenWaypoints_keepsAllBounds(seed, wind);
  }

  @Test
  void demo_sameSeed_sameBytesOfTrack() throws IOException {
    Path mission = ShortMission.in(directory);
    fly("once", "--seed", "5", "--wind", "6@30", "--mission", mission.toString());
    fly("again", "--seed", "5", "--wind", "6@30", "--mission", mission.toString());
    fly("other", "--seed", "6", "--wind", "6@30", "--mission", mission.toString());

    assertThat(bytes("again", "track.csv")).isEqualTo(bytes("once", "track.csv"));
    assertThat(bytes("again", "track.kml")).isEqualTo(bytes("once", "track.kml"));
    assertThat(bytes("other", "track.csv")).isNotEqualTo(bytes("once", "track.csv"));
  }

  @Test
  void demo_waypointMissed_endsWithOne() {
    Path mission =
        ShortMission.in(directory, "<horizontalThreshold>100<", "<horizontalThreshold>0.001<");

    CommandLineRun run = fly("out", "--wind", "8@180", "--mission", mission.toString());

    assertThat(run.exitCode()).isEqualTo(ExitCode.FAILED);
    assertThat(Summary.in(directory.resolve("out")).number("waypointsCaptured")).isZero();
  }

  /** That it is said once is LogFileFailureTest's matter. */
  @Test
  @EnabledOnOs(OS.LINUX)
  void demo_diskOfALogIsFull_fliesOn() throws IOException {
    Files.createDirectories(out("out").resolve("logs"));
    Files.createSymbolicLink(out("out").resolve("logs/Control.log"), Path.of("/dev/full"));

    CommandLineRun run = fly("out", "--mission", ShortMission.in(directory).toString());

    assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.DONE);
  }

  @Test
  void demo_configuredPortTaken_fliesAndSaysWhichPortItHas() throws IOException {
    Path mission = ShortMission.in(directory);
    try (ServerSocket holder = new ServerSocket()) {
      take(holder, CONFIGURED_PORT);

      CommandLineRun run =
          CommandLineRun.of(
              "demo", "cessna", "--mission", mission.toString(), "--out", out("out").toString());

      assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.DONE);
      assertThat(run.out())
          .containsPattern(
              "Port 1883 is taken by another program; MQTT clients find this flight on port [0-9]+ ");
    }
  }

  @Test
  void demo_portAskedForTaken_isRefusedInOneLine() throws IOException {
    Set<Thread> before = RunningThreads.now();
    try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      String port = String.valueOf(taken.getLocalPort());

      CommandLineRun run =
          CommandLineRun.of("demo", "cessna", "--port", port, "--out", out("out").toString());

      assertThat(run.exitCode()).isEqualTo(ExitCode.FAILED);
      assertThat(run.err().lines())
          .singleElement(as(STRING))
          .startsWith("u2sa: the Communication Manager cannot listen on 127.0.0.1:" + port)
          .contains("COMMUNICATION MANAGER PORT sets another");
    }
    RunningThreads.requireNoneSince(before);
  }

  /** Takes the port, unless another program has it already. */
  private static void take(ServerSocket holder, int port) {
    try {
      holder.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
    } catch (IOException e) {
      assertThat(e).isInstanceOf(BindException.class);
    }
  }

  private Path out(String name) {
    return directory.resolve(name);
  }

  private byte[] bytes(String run, String name) throws IOException {
    return Files.readAllBytes(out(run).resolve(name));
  }

  private CommandLineRun fly(String name, String... options) {
    return CommandLineRun.demo("cessna", out(name), options);
  }
}
