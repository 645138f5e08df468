package org.u2sa.core.communication;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.mqtt.BrokerAccess;
import org.u2sa.interfaces.mqtt.MqttClient;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.testkit.FreePort;
import org.u2sa.testkit.Mosquitto;
import org.u2sa.testkit.NeedsProgram;

/** MQTT through Mosquitto with OpenSSL, by our own client. */
@NeedsProgram("mosquitto")
class MosquittoTlsContractTest extends TransportContract {
  @TempDir static Path folder;
  private static SecurityDirectory directory;

  private final int port = FreePort.find();
  private final Mosquitto mosquitto;

  MosquittoTlsContractTest() throws IOException {
    Path configuration = folder.resolve("mosquitto.conf");
    Files.write(
        configuration,
        List.of(
            "listener " + port + " 127.0.0.1",
            "allow_anonymous true",
            "certfile " + directory.certificate(),
            "keyfile " + directory.key(),
            "user " + System.getProperty("user.name"))); // who may read the key
    mosquitto = Mosquitto.start(port, "-c", configuration.toString());
  }

  @BeforeAll
  static void makeAuthority() throws Exception {
    directory = TestAuthority.in(folder);
  }

  @Override
  Transport transport() {
    return new MqttTransport(
            "localhost",
            port,
            "cessna",
            new MessageCodec(StandardTypes.registry()),
            BrokerAccess.of("", "", true, directory.authority().toString()))
        .by(MqttClient.DIRECT);
  }

  @Override
  void close() {
    mosquitto.close();
  }
}
