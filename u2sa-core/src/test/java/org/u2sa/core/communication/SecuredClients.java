package org.u2sa.core.communication;

import java.io.IOException;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.mqtt.BrokerAccess;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;

/** Tests of a manager whose broker asks for users and TLS, with a user of each role. */
abstract class SecuredClients {
  @TempDir static Path authorityFolder;
  private static SecurityDirectory authority;

  @TempDir Path folder;

  final RecordingReceiver inbox = new RecordingReceiver(); // of a client that hears all, within
  SecurityDirectory directory;
  TestManager broker;

  @BeforeAll
  static void makeAuthority() throws IOException, InterruptedException, GeneralSecurityException {
    authority = TestAuthority.in(authorityFolder);
  }

  @BeforeEach
  void start() throws IOException {
    directory = TestAuthority.copy(authority, folder);
    TestAuthority.addUser(directory, "sensor", "service", "cessna");
    TestAuthority.addUser(directory, "control", "control", "cessna");
    TestAuthority.addUser(directory, "safety", "safety", "cessna");
    TestAuthority.addUser(directory, "pilot", "operator", "cessna");
    TestAuthority.addUser(directory, "screen", "observer", "cessna");
    TestAuthority.addUser(directory, "boatman", "operator", "boat");
    Map<String, Object> variables = new HashMap<>(variables());
    variables.put("SECURITY DIRECTORY", folder.toString());
    broker = new TestManager(variables);
    Connection local = broker.local("Local", inbox);
    for (Channel<?> channel : Channels.all()) {
      local.subscribe(channel);
    }
  }

  /** What the manager's configuration says besides. */
  Map<String, Object> variables() {
    return Map.of();
  }

  @AfterEach
  void stop() {
    broker.close();
  }

  MqttTransport transport(BrokerAccess access, String system) {
    return new MqttTransport(
            "localhost", broker.port, system, new MessageCodec(StandardTypes.registry()), access)
        .waiting(TestManager.PATIENCE_S);
  }

  BrokerAccess accessOf(String user) {
    return BrokerAccess.of(
        user,
        folder.resolve(user + ".password").toString(),
        true,
        directory.authority().toString());
  }

  Connection connect(String user, RecordingReceiver receiver) {
    return broker.keep(transport(accessOf(user), "cessna").connect("Remote", receiver));
  }

  Connection connect(String user) {
    return connect(user, new RecordingReceiver());
  }

  void awaitLog(String... parts) {
    BrokerTraffic.soon()
        .until(
            () ->
                broker.log.stream()
                    .anyMatch(line -> List.of(parts).stream().allMatch(line::contains)));
  }
}
