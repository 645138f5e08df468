package org.u2sa.core.launch;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationUndo;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.testkit.FreePort;
import org.u2sa.testkit.Mosquitto;
import org.u2sa.testkit.NeedsProgram;
import org.u2sa.testkit.ProcessTree;

/**
 * User story 1: a sensor written in Python feeds the State Estimator of a Java system, and answers
 * like any other service.
 */
@Timeout(120)
@NeedsProgram(
    value = "python3",
    modules = {"cbor2", "paho.mqtt.client"})
class PythonServiceTest {
  private static final double TURN = 2.0 * Math.PI;

  @TempDir private Path directory;

  @Test
  void unittest_ofTheClient_passes() throws IOException, InterruptedException {
    assertThat(Python.required().run("-m", "unittest")).startsWith("exit code 0").contains("OK");
  }

  @Test
  void compassInPython_inAJavaSystem_isAServiceLikeAnyOther()
      throws IOException, InterruptedException {
    isAServiceLikeAnyOther(FreePort.find(), "embedded");
  }

  @Test
  @NeedsProgram("mosquitto")
  void compassInPython_inAJavaSystemWithMosquitto_isAServiceLikeAnyOther()
      throws IOException, InterruptedException {
    try (Mosquitto mosquitto = Mosquitto.start(FreePort.find())) {
      isAServiceLikeAnyOther(mosquitto.port(), "external");
    }
  }

  private void isAServiceLikeAnyOther(int port, String broker)
      throws IOException, InterruptedException {
    Python python = Python.required();
    Path file = file("Compass.xml", "<configuration>\n  <!-- of the boat -->\n</configuration>\n");
    LaunchOptions options = new LaunchOptions().logDirectory(directory.resolve("logs"));
    try (RunningSystem system = RunningSystem.start(estimator(port, broker), options);
        BoatOperator operator = new BoatOperator(port)) {
      Process compass = compass(python, port, file);
      try {
        StateInformation state =
            operator.awaited(StateInformation.class, each -> each.psi().isPresent());
        assertThat(state.sensorName()).isEqualTo("StateEstimator");
        assertThat(state.x()).isEmpty();
        assertThat(state.psiSigma()).hasValue(0.02);

        discoveredAsItIs(operator);
        turnedByConfiguration(operator, file);

        operator.heard.removeIf(ConnectionLost.class::isInstance); // of a machine busy for seconds
        operator.send(Channels.STOP, new StopCommand().serviceName("Compass"));
        assertThat(compass.waitFor(20, TimeUnit.SECONDS)).isTrue();
        assertThat(compass.exitValue()).as(Files.readString(output(), UTF_8)).isZero();
        assertThat(
                operator
                    .awaited(
                        HealthReport.class,
                        report ->
                            report.serviceName().equals("Compass")
                                && report.status() == ServiceStatus.STOPPED)
                    .exceptions())
            .isZero();
        assertThat(operator.heard)
            .as("a clean end sends no will")
            .noneMatch(ConnectionLost.class::isInstance);
        assertThat(system.isRunning()).isTrue();
      } finally {
        ProcessTree.kill(compass);
      }
    }
  }

  @Test
  void compassInPython_killed_brokerTellsItsWill() throws IOException, InterruptedException {
    Python python = Python.required();
    int port = FreePort.find();
    LaunchOptions options = new LaunchOptions().logDirectory(directory.resolve("logs"));
    try (RunningSystem system = RunningSystem.start(estimator(port, "embedded"), options);
        BoatOperator operator = new BoatOperator(port)) {
      assertThat(system.isRunning()).isTrue();
      assertThat(operator.refused()).isZero();
      Process compass = compass(python, port, file("Compass.xml", "<configuration/>"));
      HealthReport report =
          operator.awaited(HealthReport.class, each -> each.serviceName().equals("Compass"));

      compass.destroyForcibly();

      ConnectionLost will = operator.awaited(ConnectionLost.class, each -> true);
      assertThat(will.serviceName()).isEqualTo("Compass");
      assertThat(will.instance()).isPresent().isEqualTo(report.instance());
    }
  }

  private void discoveredAsItIs(BoatOperator operator) {
    operator.send(Channels.DISCOVERY, new DiscoveryRequest());
    DiscoveryResponse compass =
        operator.awaited(DiscoveryResponse.class, each -> each.serviceName().equals("Compass"));
    assertThat(compass.serviceType()).isEqualTo("PROPRIOCEPTIVE_SENSOR");
    assertThat(compass.status()).isEqualTo(ServiceStatus.RUNNING);
    assertThat(compass.uptime()).isPositive();
    operator.send(Channels.FUNCTIONALITY, new FunctionalityRequest().serviceName("Compass"));
    assertThat(operator.awaited(FunctionalityResponse.class, each -> true).publishes())
        .containsExactly("sensed-state/StateInformation");
  }

  private void turnedByConfiguration(BoatOperator operator, Path file) throws IOException {
    ConfigurationTransactionResult refused = operator.changed("r-1", "9.0");
    assertThat(refused.accepted()).isFalse();
    assertThat(refused.reason()).contains("DECLINATION").contains("9.0 is outside -3.14");

    ConfigurationTransactionResult done = operator.changed("r-2", "2.5");
    assertThat(done.accepted()).as(done.reason()).isTrue();
    assertThat(done.revision()).isEqualTo(1);
    assertThat(done.assignments().get(0).previous()).isEqualTo(Optional.of("0.0"));
    assertThat(Files.readString(file)).contains("of the boat").contains("2.5");
    operator.awaited(
        StateInformation.class, state -> declination(state) > 2.4 && declination(state) < 2.6);

    operator.send(
        Channels.CONFIGURATION,
        new ConfigurationUndo().requestId("r-3").serviceName("Compass").author("test"));
    assertThat(operator.result("r-3").assignments().get(0).value()).isEqualTo("0.0");
  }

  /** What the simulated compass adds to its turn of once a minute. */
  private static double declination(StateInformation state) {
    double second = state.timestamp().orElseThrow() / 1e6 % 60.0;
    double difference = state.psi().orElse(0.0) - TURN * second / 60.0;
    return (difference % TURN + TURN) % TURN;
  }

  private Process compass(Python python, int port, Path configuration) throws IOException {
    return python.start(
        output().toFile(),
        "examples/compass.py",
        "--simulate",
        "--system",
        "boat",
        "--broker",
        "127.0.0.1:" + port,
        "--configuration",
        configuration.toString());
  }

  private Path output() {
    return directory.resolve("compass.txt");
  }

  private SystemFile estimator(int port, String broker) throws IOException {
    file(
        "Manager.xml",
        "<configuration><variable name=\"BROKER\" type=\"string\" value=\""
            + broker
            + "\"/><variable name=\"COMMUNICATION MANAGER PORT\" type=\"int\" value=\""
            + port
            + "\"/></configuration>");
    file("Estimator.xml", "<configuration/>");
    return SystemFile.read(
        file(
            "system.xml",
            "<system id=\"boat\"><communication configuration=\"Manager.xml\"/>"
                + "<service class=\"org.u2sa.estimation.PassThroughStateEstimator\""
                + " configuration=\"Estimator.xml\"/></system>"));
  }

  private Path file(String name, String text) throws IOException {
    return Files.writeString(directory.resolve(name), text);
  }
}
