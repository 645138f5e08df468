package org.u2sa.scenarios.cessna;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.flightgear.link.EmbeddedStart;
import org.u2sa.flightgear.link.StandInFlightGear;
import org.u2sa.flightgear.link.StandInSetup;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.mission.Mission;
import org.u2sa.scenarios.run.CommandLineRun;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.atmosphere.Wind;

/** {@code u2sa fly} when FlightGear never comes, or goes. */
@Timeout(300)
class FlightGearLostTest {
  private static final String HOST = "127.0.0.1";
  private static final Duration PATIENCE = Duration.ofSeconds(120); // each wait ends with its event

  /** How long {@code fly} waits [s]: more than a busy machine keeps the aircraft from speaking. */
  private static final String LONG_WAIT_S = "8";

  @TempDir private Path directory;

  @Test
  void fly_flightGearNeverComes_givesUpAndFails() throws IOException {
    Set<Thread> before = RunningThreads.now();

    CommandLineRun run = fly(freePort(), freePort(), "0.5");

    assertThat(run.exitCode()).isEqualTo(ExitCode.FAILED);
    assertThat(run.out())
        .contains("Listening. Start FlightGear now")
        .contains("No readings from the aircraft for 0.5 s: giving up.");
    assertThat(run.err())
        .startsWith("u2sa: no reading from the aircraft: FlightGear did not appear")
        .hasLineCount(1);
    RunningThreads.requireNoneSince(before);
  }

  @Test
  void fly_flightGearGoesAndGarbageComes_reportsWhatWasFlownAndFails() throws IOException {
    Mission mission = Mission.load(ShortMission.in(directory));
    Cessna172 aircraft =
        Cessna172.onRunway(EmbeddedStart.of(mission), Wind.constant(0.0, 0.0), true);
    int outPort = freePort();
    CompletableFuture<CommandLineRun> flying;
    try (StandInFlightGear standIn =
        new StandInFlightGear(
            aircraft, StandInSetup.likeFlightGear(), HOST, 0, 0, new SystemClock())) {
      int inPort = standIn.inPort();
      flying = CompletableFuture.supplyAsync(() -> fly(outPort, inPort, LONG_WAIT_S));
      sendGarbage(outPort); // once it is taken somebody listens, and FlightGear connects only once
      standIn.start(HOST, outPort);
      awaitLog("Control", "phase R"); // RUN_UP
    }
    CommandLineRun run = flying.join();

    assertThat(run.exitCode()).isEqualTo(ExitCode.FAILED);
    assertThat(run.out())
        .containsPattern("No readings from the aircraft for \\d+\\.\\d s; waiting for them\\.")
        .containsPattern("No readings from the aircraft for \\d+\\.\\d s: giving up\\.");
    assertThat(Summary.in(directory.resolve("out")).number("waypointsCaptured")).isZero();
    assertThat(directory.resolve("out/logs/Simulator.log"))
        .content(UTF_8)
        .contains("aircraft connected", "aircraft lost", "ended: STOPPED");
  }

  /** A stray client before the real one: no FlightGear, and not for long. */
  private static void sendGarbage(int port) {
    await()
        .atMost(PATIENCE)
        .ignoreExceptionsInstanceOf(IOException.class)
        .until(
            () -> {
              try (Socket stray = new Socket(HOST, port)) {
                if (stray.getLocalPort() == port) {
                  return false; // nobody listens yet: TCP has joined the socket to itself
                }
                stray.getOutputStream().write("GET / HTTP/1.1\n1,2,\n\0\0\n".getBytes(UTF_8));
                return true;
              }
            });
  }

  private void awaitLog(String service, String words) {
    Path log = directory.resolve("out/logs/" + service + ".log");
    await()
        .atMost(PATIENCE)
        .until(() -> Files.exists(log) && Files.readString(log).contains(words));
  }

  private CommandLineRun fly(int outPort, int inPort, String waitS) {
    return CommandLineRun.of(
        "fly",
        "--flightgear",
        "--no-start",
        "--port",
        "0",
        "--mission",
        ShortMission.in(directory).toString(),
        "--out-port",
        String.valueOf(outPort),
        "--in-port",
        String.valueOf(inPort),
        "--props-port",
        "0",
        "--wait",
        waitS,
        "--out",
        directory.resolve("out").toString());
  }

  private static int freePort() throws IOException {
    try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return free.getLocalPort();
    }
  }
}
