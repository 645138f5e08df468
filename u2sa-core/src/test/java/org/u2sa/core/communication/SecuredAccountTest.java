package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.u2sa.core.communication.BrokerTraffic.frozen;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.mqtt.AccountFolders;
import org.u2sa.interfaces.mqtt.BrokerAccess;
import org.u2sa.interfaces.mqtt.LocalToken;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.safety.EmergencyStop;

/** Programs of the account that started a secured broker, on its host. */
@Timeout(120)
@DisabledOnOs(OS.WINDOWS)
class SecuredAccountTest extends SecuredClients {
  private Path login;

  @BeforeEach
  void find() {
    login =
        AccountFolders.ofProcess()
            .all()
            .get(0)
            .resolve(LocalToken.loginFileName("127.0.0.1", broker.port));
  }

  @Test
  void login_ofARunningBroker_isItsAccountsAloneAndGoneAfterwards() throws IOException {
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(login)))
        .isEqualTo("rw-------");
    broker.manager().close();
    assertThat(login).doesNotExist();
  }

  @Test
  void account_withoutOptions_commandsOverTls() {
    EmergencyStop stop = frozen(new EmergencyStop().active(true));

    broker
        .keep(transport(BrokerAccess.open(), "cessna").connect("Tool", new RecordingReceiver()))
        .publish(Channels.EMERGENCY_STOP, stop);

    inbox.awaitMessage(stop);
  }

  @Test
  void otherAccount_withoutOptions_isRefused() throws IOException {
    Files.setPosixFilePermissions(login, PosixFilePermissions.fromString("rw-r--r--"));

    assertThatThrownBy(
            () -> transport(BrokerAccess.open(), "cessna").waiting(0.0).connect("Tool", inbox))
        .isInstanceOf(CommunicationException.class);
  }

  /** As {@code run --separate} starts it, with the variables of the whole system. */
  @Test
  void childProcess_withoutUser_joinsAsItsAccount() {
    try (CommunicationManager child =
        CommunicationManager.start(
            "cessna",
            XmlConfiguration.inMemory(
                "test",
                Map.of(
                    "BROKER",
                    "external",
                    "COMMUNICATION MANAGER PORT",
                    broker.port,
                    "COMMUNICATION MANAGER WAIT",
                    TestManager.PATIENCE_S,
                    "SECURITY DIRECTORY",
                    folder.toString())),
            StandardTypes.registry(),
            line -> {})) {
      EmergencyStop stop = frozen(new EmergencyStop().active(true));
      Transport transport = child.transport();
      broker
          .keep(transport.connect("SafetyManager", new RecordingReceiver()))
          .publish(Channels.EMERGENCY_STOP, stop);

      inbox.awaitMessage(stop);
    }
  }
}
