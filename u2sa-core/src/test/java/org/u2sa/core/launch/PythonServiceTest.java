package org.u2sa.core.launch;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.MqttTransport;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.messages.MessageCodec;
import org.u2sa.messages.MessageTypes;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.U2SAData;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationUndo;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.contract.StopCommand;

/**
 * User story 1: a sensor written in Python feeds the State Estimator of a Java system, and answers
 * like any other service.
 */
@Timeout(120)
class PythonServiceTest {
  private static final double TURN = 2.0 * Math.PI;

  @TempDir private Path directory;
  private final List<U2SAData> heard = new CopyOnWriteArrayList<>();

  @Test
  void unittest_ofTheClient_passes() throws IOException, InterruptedException {
    assertThat(Python.required().run("-m", "unittest")).startsWith("exit code 0").contains("OK");
  }

  @Test
  void compassInPython_inAJavaSystem_isAServiceLikeAnyOther()
      throws IOException, InterruptedException {
    isAServiceLikeAnyOther(freePort(), "embedded");
  }

  @Test
  void compassInPython_inAJavaSystemWithMosquitto_isAServiceLikeAnyOther()
      throws IOException, InterruptedException {
    try (Mosquitto mosquitto = Mosquitto.start(freePort())) {
      isAServiceLikeAnyOther(mosquitto.port(), "external");
    }
  }

  private void isAServiceLikeAnyOther(int port, String broker)
      throws IOException, InterruptedException {
    Python python = Python.required();
    Path file = file("Compass.xml", "<configuration>\n  <!-- of the boat -->\n</configuration>\n");
    LaunchOptions options = new LaunchOptions().logDirectory(directory.resolve("logs"));
    try (RunningSystem system = RunningSystem.start(estimator(port, broker), options);
        Connection operator = operator(port)) {
      Process compass = compass(python, port, file);
      try {
        StateInformation state = awaited(StateInformation.class, each -> each.psi().isPresent());
        assertThat(state.sensorName()).isEqualTo("StateEstimator");
        assertThat(state.x()).isEmpty();
        assertThat(state.psiSigma()).hasValue(0.02);

        discoveredAsItIs(operator);
        turnedByConfiguration(operator, file);

        heard.removeIf(ConnectionLost.class::isInstance); // of a machine busy for seconds
        operator.publish(Channels.STOP, ready(new StopCommand().serviceName("Compass")));
        assertThat(compass.waitFor(20, TimeUnit.SECONDS)).isTrue();
        assertThat(compass.exitValue()).as(Files.readString(output(), UTF_8)).isZero();
        assertThat(
                awaited(
                        HealthReport.class,
                        report ->
                            report.serviceName().equals("Compass")
                                && report.status() == ServiceStatus.STOPPED)
                    .exceptions())
            .isZero();
        assertThat(heard)
            .as("a clean end sends no will")
            .noneMatch(ConnectionLost.class::isInstance);
        assertThat(system.isRunning()).isTrue();
      } finally {
        compass.destroyForcibly();
      }
    }
  }

  @Test
  void compassInPython_killed_brokerTellsItsWill() throws IOException, InterruptedException {
    Python python = Python.required();
    int port = freePort();
    LaunchOptions options = new LaunchOptions().logDirectory(directory.resolve("logs"));
    try (RunningSystem system = RunningSystem.start(estimator(port, "embedded"), options);
        Connection operator = operator(port)) {
      assertThat(system.isRunning()).isTrue();
      assertThat(operator.refused()).isZero();
      Process compass = compass(python, port, file("Compass.xml", "<configuration/>"));
      HealthReport report =
          awaited(HealthReport.class, each -> each.serviceName().equals("Compass"));

      compass.destroyForcibly();

      ConnectionLost will = awaited(ConnectionLost.class, each -> true);
      assertThat(will.serviceName()).isEqualTo("Compass");
      assertThat(will.instance()).isPresent().isEqualTo(report.instance());
    }
  }

  private void discoveredAsItIs(Connection operator) {
    operator.publish(Channels.DISCOVERY, ready(new DiscoveryRequest()));
    DiscoveryResponse compass =
        awaited(DiscoveryResponse.class, each -> each.serviceName().equals("Compass"));
    assertThat(compass.serviceType()).isEqualTo("PROPRIOCEPTIVE_SENSOR");
    assertThat(compass.status()).isEqualTo(ServiceStatus.RUNNING);
    assertThat(compass.uptime()).isPositive();
    operator.publish(
        Channels.FUNCTIONALITY, ready(new FunctionalityRequest().serviceName("Compass")));
    assertThat(awaited(FunctionalityResponse.class, each -> true).publishes())
        .containsExactly("sensed-state/StateInformation");
  }

  private void turnedByConfiguration(Connection operator, Path file) throws IOException {
    ConfigurationTransactionResult refused = changed(operator, "r-1", "9.0");
    assertThat(refused.accepted()).isFalse();
    assertThat(refused.reason()).contains("DECLINATION").contains("9.0 is outside -3.14");

    ConfigurationTransactionResult done = changed(operator, "r-2", "2.5");
    assertThat(done.accepted()).as(done.reason()).isTrue();
    assertThat(done.revision()).isEqualTo(1);
    assertThat(done.assignments().get(0).previous()).isEqualTo(Optional.of("0.0"));
    assertThat(Files.readString(file)).contains("of the boat").contains("2.5");
    awaited(StateInformation.class, state -> declination(state) > 2.4 && declination(state) < 2.6);

    operator.publish(
        Channels.CONFIGURATION,
        ready(new ConfigurationUndo().requestId("r-3").serviceName("Compass").author("test")));
    assertThat(result("r-3").assignments().get(0).value()).isEqualTo("0.0");
  }

  /** What the simulated compass adds to its turn of once a minute. */
  private static double declination(StateInformation state) {
    double second = state.timestamp().orElseThrow() / 1e6 % 60.0;
    double difference = state.psi().orElse(0.0) - TURN * second / 60.0;
    return (difference % TURN + TURN) % TURN;
  }

  private ConfigurationTransactionResult changed(
      Connection operator, String request, String value) {
    ConfigurationAssignment wanted =
        new ConfigurationAssignment().variableName("DECLINATION").value(value);
    operator.publish(
        Channels.CONFIGURATION,
        ready(
            new ConfigurationTransaction()
                .requestId(request)
                .serviceName("Compass")
                .assignments(List.of(wanted))
                .author("test")));
    return result(request);
  }

  private ConfigurationTransactionResult result(String request) {
    return awaited(ConfigurationTransactionResult.class, each -> each.requestId().equals(request));
  }

  private <T extends U2SAData> T awaited(Class<T> type, Predicate<T> wanted) {
    return await()
        .atMost(Duration.ofSeconds(30))
        .until(
            () ->
                heard.stream().filter(type::isInstance).map(type::cast).filter(wanted).findFirst(),
            Optional::isPresent)
        .orElseThrow();
  }

  private static <T extends U2SAData> T ready(T message) {
    message.systemId("boat");
    message.freeze();
    return message;
  }

  private Connection operator(int port) {
    Receiver receiver =
        new Receiver() {
          @Override
          public void receive(Channel<?> channel, U2SAData message) {
            heard.add(message);
          }

          @Override
          public void trouble(String what) {
            throw new AssertionError(what);
          }
        };
    Connection connection =
        new MqttTransport("127.0.0.1", port, "boat", new MessageCodec(MessageTypes.standard()))
            .connect("Operator", receiver);
    for (Channel<?> channel :
        List.of(
            Channels.STATE,
            Channels.HEALTH,
            Channels.DISCOVERY,
            Channels.FUNCTIONALITY,
            Channels.CONFIGURATION)) {
      connection.subscribe(channel);
    }
    return connection;
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
                + "<service class=\"org.u2sa.core.estimation.PassThroughStateEstimator\""
                + " configuration=\"Estimator.xml\"/></system>"));
  }

  private Path file(String name, String text) throws IOException {
    return Files.writeString(directory.resolve(name), text);
  }

  private static int freePort() throws IOException {
    try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return free.getLocalPort();
    }
  }
}
