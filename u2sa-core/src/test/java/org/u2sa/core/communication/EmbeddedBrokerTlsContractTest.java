package org.u2sa.core.communication;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.mqtt.BrokerAccess;
import org.u2sa.interfaces.mqtt.MqttClient;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;

/** MQTT through the embedded broker, encrypted, by our own client. */
class EmbeddedBrokerTlsContractTest extends TransportContract {
  private static final String USER = "all";

  @TempDir static Path folder;
  private static SecurityDirectory directory;

  private final TestManager manager =
      new TestManager(Map.of("SECURITY DIRECTORY", folder.toString()));

  @BeforeAll
  static void makeAuthority() throws Exception {
    directory = TestAuthority.in(folder);
    TestAuthority.addUser(directory, USER, "service,control,safety,operator", "cessna");
  }

  MqttClient client() {
    return MqttClient.DIRECT;
  }

  @Override
  Transport transport() {
    BrokerAccess access =
        BrokerAccess.of(
            USER,
            folder.resolve(USER + ".password").toString(),
            true,
            directory.authority().toString());
    return new MqttTransport(
            "localhost", manager.port, "cessna", new MessageCodec(StandardTypes.registry()), access)
        .waiting(TestManager.PATIENCE_S)
        .by(client());
  }

  @Override
  void close() {
    manager.close();
  }
}
