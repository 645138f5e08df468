package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import io.moquette.broker.Server;
import io.moquette.broker.config.IConfig;
import io.moquette.broker.config.MemoryConfig;
import io.moquette.broker.security.PermitAllAuthorizatorPolicy;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.testkit.FreePort;
import org.u2sa.testkit.TcpRelay;

/**
 * What a client meets in the moment in which Moquette listens and the connection filter does not
 * hang yet.
 */
@Timeout(60)
class FilterInstallerTest {
  private static final MessageCodec CODEC = new MessageCodec(StandardTypes.registry());

  private final Server server = new Server();
  private int port;
  private ConnectionFilter filter;

  @BeforeEach
  void start() throws IOException {
    port = FreePort.find();
    filter =
        new ConnectionFilter(
            XmlConfiguration.inMemory("test", Map.of()).settings(BrokerLimits.class).get(),
            CODEC,
            new SystemClock(),
            null,
            null,
            line -> {});
    Properties properties = new Properties();
    properties.setProperty(IConfig.HOST_PROPERTY_NAME, "127.0.0.1");
    properties.setProperty(IConfig.PORT_PROPERTY_NAME, String.valueOf(port));
    properties.setProperty(IConfig.ALLOW_ANONYMOUS_PROPERTY_NAME, "false");
    properties.setProperty(IConfig.PERSISTENCE_ENABLED_PROPERTY_NAME, "false");
    properties.setProperty(IConfig.ENABLE_TELEMETRY_NAME, "false");
    server.startServer(
        new MemoryConfig(properties),
        List.of(),
        () -> null,
        (clientId, user, password) -> filter.letIn(password),
        new PermitAllAuthorizatorPolicy());
  }

  @AfterEach
  void stop() {
    FilterInstaller.takeDown(server);
    server.stopServer();
  }

  @Test
  void connect_withAUser_endsWithoutAnAnswerThatWouldBeFinal() throws IOException {
    try (RawClient client = new RawClient(port)) {
      assertThat(client.introduce("early", "ann", "secret")).isEqualTo(-1);
    }
  }

  @Test
  void connect_withoutAUser_comesAgainUntilTheDoorHangs() throws IOException {
    try (TcpRelay wire = new TcpRelay(port)) {
      MqttTransport early =
          new MqttTransport("127.0.0.1", wire.port(), "cessna", CODEC).waiting(45.0);
      CompletableFuture<Connection> coming =
          CompletableFuture.supplyAsync(() -> early.connect("Early", new RecordingReceiver()));
      soon().until(() -> wire.connections() > 1); // so the first was refused

      FilterInstaller.install(filter, server);

      Connection connection = coming.join();
      assertThat(connection.instance()).isNotEmpty();
      connection.close();
    }
  }
}
