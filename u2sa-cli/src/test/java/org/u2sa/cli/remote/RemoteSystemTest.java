package org.u2sa.cli.remote;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.gcs.remote.BrokerAddress;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.testkit.FreePort;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.ParameterException;

@Timeout(60)
class RemoteSystemTest {
  private static final String ESTIMATOR = "org.u2sa.estimation.PassThroughStateEstimator";

  @TempDir private static Path directory;
  private static ForeignSystem foreign;

  /** Stands for any command. */
  @Command(name = "probe")
  private static final class Probe {
    @Mixin private RemoteSystem remote;
  }

  /** Ignores what comes. */
  private static final class Deaf implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {}

    @Override
    public void trouble(String what) {}
  }

  @BeforeAll
  static void start() {
    foreign = ForeignSystem.start(directory, "rover", ESTIMATOR);
  }

  @AfterAll
  static void end() {
    foreign.close();
  }

  private static RemoteSystem remote(String... options) {
    Probe probe = new Probe();
    new CommandLine(probe).parseArgs(options);
    return probe.remote;
  }

  @Test
  void connect_systemOfAnotherProcess_isFoundAndAnswers() throws Exception {
    try (RemoteLink link = remote("--broker", foreign.broker(), "--timeout", "20").connect()) {
      assertThat(link.systemId()).isEqualTo("rover");
      long before = link.clock().micros();

      Set<String> answers = ConcurrentHashMap.newKeySet();
      link.ask(
          Channels.DISCOVERY,
          new DiscoveryRequest(),
          DiscoveryResponse.class,
          answer -> answers.add(answer.serviceName()),
          () -> answers.contains("StateEstimator"));

      assertThat(answers).contains("StateEstimator");
      assertThat(Clock.seconds(link.clock().micros() - before))
          .as("ended when the expected one was in, not at the time-out")
          .isLessThan(15.0);
    }
  }

  @Test
  void ask_nobodyAnswers_endsAtTheTimeOutWithoutAnswers() throws Exception {
    try (RemoteLink link =
        remote("--broker", foreign.broker(), "--system", "boat", "--timeout", "0.3").connect()) {
      assertThat(
              link.first(
                  Channels.DISCOVERY,
                  new DiscoveryRequest(),
                  DiscoveryResponse.class,
                  answer -> true))
          .isEmpty();
    }
  }

  @Test
  void connect_severalSystems_listsThem() throws Exception {
    MqttTransport other =
        new MqttTransport(
            "127.0.0.1", foreign.port(), "boat", new MessageCodec(StandardTypes.registry()));
    SystemClock clock = new SystemClock();
    try (Connection boat = other.connect("Engine", new Deaf());
        Clock.Waiter pause = clock.newWaiter("pause")) {
      Thread reports =
          new Thread(
              () -> {
                try {
                  while (!Thread.currentThread().isInterrupted()) {
                    HealthReport report =
                        new HealthReport().serviceName("Engine").status(ServiceStatus.RUNNING);
                    report.systemId("boat");
                    report.timestamp(clock.micros());
                    report.freeze();
                    boat.publish(Channels.HEALTH, report);
                    pause.await(clock.micros() + 50_000);
                  }
                } catch (InterruptedException e) {
                  Thread.currentThread().interrupt();
                }
              });
      reports.start();

      RemoteSystem remote = remote("--broker", foreign.broker());

      assertThatThrownBy(remote::connect)
          .isInstanceOf(BadInputException.class)
          .hasMessageContaining("boat, rover")
          .hasMessageContaining("--system");
      reports.interrupt();
      reports.join();
    }
  }

  @Test
  void connect_noBroker_saysWhereInOneLine() {
    String nobody = "127.0.0.1:" + FreePort.find();

    assertThatThrownBy(() -> remote("--broker", nobody).connect())
        .isInstanceOf(CommunicationException.class)
        .hasMessageContaining("no Communication Manager at")
        .hasMessageContaining(nobody)
        .hasMessageNotContaining("\n");
  }

  @Test
  void connect_brokerWithoutSystem_saysSo() {
    int port = FreePort.find();
    XmlConfiguration configuration =
        XmlConfiguration.inMemory("test", java.util.Map.of("COMMUNICATION MANAGER PORT", port));
    CommunicationManager silent =
        CommunicationManager.start("quiet", configuration, StandardTypes.registry(), line -> {});
    try {
      RemoteSystem remote = remote("--broker", "127.0.0.1:" + port, "--timeout", "0.2");

      assertThatThrownBy(remote::connect)
          .isInstanceOf(RunFailedException.class)
          .hasMessageContaining("no system found at 127.0.0.1:" + port);
    } finally {
      silent.close();
    }
  }

  @ParameterizedTest
  @CsvSource({
    "localhost, localhost, 1883",
    "robot.local:1884, robot.local, 1884",
    "10.0.0.7:65535, 10.0.0.7, 65535",
    "[::1]:1885, ::1, 1885"
  })
  void parse_address_isTakenApart(String text, String host, int port) {
    assertThat(BrokerAddress.parse(text)).isEqualTo(new BrokerAddress(host, port));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", ":1883", "a:b", "a:0", "a:65536", "tcp://a:1", "a b"})
  void parse_otherText_isRefused(String text) {
    assertThatThrownBy(() -> remote("--broker", text))
        .isInstanceOf(ParameterException.class)
        .hasMessageContaining("--broker \"" + text + "\"");
  }

  @ParameterizedTest
  @CsvSource({"--timeout, 0", "--timeout, -1", "--timeout, NaN", "--system, a/b", "--system, +"})
  void options_outOfRange_nameTheOption(String option, String value) {
    assertThatThrownBy(() -> remote(option, value))
        .isInstanceOf(ParameterException.class)
        .hasMessageContaining(option);
  }
}
