package org.u2sa.scenarios.cessna;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.scenarios.run.ForeignProgram;
import org.u2sa.testkit.FreePort;
import org.u2sa.testkit.Mosquitto;
import org.u2sa.testkit.NeedsProgram;
import org.u2sa.testkit.ProcessTree;
import org.u2sa.testkit.Repository;

/**
 * A client that nobody here wrote (paho-mqtt, cbor2) sees exactly what docs/wire-protocol.md says:
 * scripts/wire/check.py holds every message to the page's tables.
 */
@Timeout(180)
@NeedsProgram(
    value = "python3",
    modules = {"cbor2", "paho.mqtt.client"})
class PlainClientTest {
  private static final Duration LONG = Duration.ofSeconds(90);

  @TempDir private Path directory;
  private Process system;
  private Mosquitto broker;
  private Process check;

  @AfterEach
  void end() {
    for (Process process : new Process[] {check, system}) {
      if (process != null) {
        ProcessTree.kill(process);
      }
    }
    if (broker != null) {
      broker.close();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = "readable")
  void cessna_throughTheEmbeddedBroker_isWhatThePageSays(String form)
      throws IOException, InterruptedException {
    String python = ForeignProgram.python();
    int port = FreePort.find();
    system =
        ForeignProgram.u2sa(
            file("demo.txt"),
            "demo",
            "cessna",
            "--realtime",
            "--set",
            "CommunicationManager:WIRE FORM=" + form,
            "--port",
            String.valueOf(port),
            "--out",
            file("out").toString());
    awaitListener(port);

    check = check(python, port, "--seconds", "2");

    assertThat(check.waitFor(LONG.toSeconds(), TimeUnit.SECONDS)).isTrue();
    assertSeen("services: Control, FlightObserver, HealthMonitor, Launcher, MissionManager,");
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(strings = "compact")
  void cessna_throughTheEmbeddedBrokerInCompactForm_isWhatThePageSays(String form)
      throws IOException, InterruptedException {
    cessna_throughTheEmbeddedBroker_isWhatThePageSays(form);
  }

  @Test
  @NeedsProgram("mosquitto")
  void cessna_throughMosquittoAndKilled_isWhatThePageSaysWillsToo()
      throws IOException, InterruptedException {
    String python = ForeignProgram.python();
    int port = FreePort.find();
    broker = Mosquitto.start(port);
    system =
        ForeignProgram.u2sa(
            file("run.txt"),
            "run",
            Repository.root().resolve("config/cessna/system.xml").toString(),
            "--logs",
            file("logs").toString(),
            "--set",
            "CommunicationManager:BROKER=external",
            "--set",
            "CommunicationManager:COMMUNICATION MANAGER PORT=" + port);

    check = check(python, port, "--seconds", "2", "--wills", "8");
    await().atMost(LONG).until(() -> output("check.txt").contains("kill now") || !check.isAlive());
    ProcessTree.kill(system);

    assertThat(check.waitFor(LONG.toSeconds(), TimeUnit.SECONDS)).isTrue();
    assertSeen("wills: Control, HealthMonitor, Launcher, MissionManager, PathPlanner,");
  }

  private void assertSeen(String line) throws IOException {
    assertThat(check.exitValue()).as(output("check.txt")).isZero();
    assertThat(output("check.txt"))
        .contains("checked, 0 differences")
        .contains(line)
        .contains("retained u2sa/cessna/actuators/ActuatorAnnouncement/=RUDDER")
        .contains("u2sa/cessna/state/StateInformation/AircraftState");
  }

  private Process check(String python, int port, String... options) throws IOException {
    Path script = Repository.root().resolve("scripts/wire/check.py");
    List<String> command =
        new ArrayList<>(
            List.of(
                python,
                script.toString(),
                "--broker",
                "127.0.0.1:" + port,
                "--expect",
                "state,actuation"));
    command.addAll(List.of(options));
    return ForeignProgram.start(file("check.txt"), command);
  }

  private static void awaitListener(int port) {
    await()
        .atMost(LONG)
        .ignoreExceptions()
        .until(
            () -> {
              new Socket("127.0.0.1", port).close();
              return true;
            });
  }

  private Path file(String name) {
    return directory.resolve(name);
  }

  private String output(String name) throws IOException {
    return Files.exists(file(name)) ? Files.readString(file(name), UTF_8) : "";
  }
}
