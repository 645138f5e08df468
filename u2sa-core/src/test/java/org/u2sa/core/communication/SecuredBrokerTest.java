package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.u2sa.core.communication.BrokerTraffic.command;
import static org.u2sa.core.communication.BrokerTraffic.frozen;
import static org.u2sa.core.communication.BrokerTraffic.publishUntilReceived;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.GeneralSecurityException;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.core.security.UserFile;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.safety.EmergencyStop;

/** What a user of the embedded broker may do, and what a broker needs to ask for users at all. */
@Timeout(120)
class SecuredBrokerTest extends SecuredClients {
  @Test
  void publish_actuation_isTakenFromControlOnly() {
    PercentageCommand wrong = command(99.0);
    PercentageCommand right = command(1.0);
    StateInformation state = frozen(new StateInformation().sensorName("gps").x(1.0));
    Connection sensor = connect("sensor");

    sensor.publish(Channels.ACTUATION, wrong);
    sensor.publish(Channels.STATE, state);
    connect("control").publish(Channels.ACTUATION, right);

    soon().until(() -> inbox.messages.contains(right) && inbox.messages.contains(state));
    assertThat(inbox.messages).doesNotContain(wrong);
    awaitLog(
        "role service may not publish on actuation",
        "\"sensor\"",
        "127.0.0.1",
        "u2sa/cessna/actuation");
  }

  @Test
  void publish_emergencyStop_safetyMaySetAndOnlyTheOperatorClears() {
    EmergencyStop set = frozen(new EmergencyStop().active(true));
    EmergencyStop byService = frozen(new EmergencyStop().active(true).reason("no right"));
    EmergencyStop bySafety = frozen(new EmergencyStop().active(false).clears(1).reason("no right"));
    EmergencyStop byOperator = frozen(new EmergencyStop().active(false).clears(1));

    connect("sensor").publish(Channels.EMERGENCY_STOP, byService);
    Connection safety = connect("safety");
    safety.publish(Channels.EMERGENCY_STOP, bySafety);
    safety.publish(Channels.EMERGENCY_STOP, set);
    connect("pilot").publish(Channels.EMERGENCY_STOP, byOperator);

    soon().until(() -> inbox.messages.contains(set) && inbox.messages.contains(byOperator));
    assertThat(inbox.messages).doesNotContain(byService, bySafety);
    awaitLog("only an operator may clear an emergency stop", "\"safety\"");
  }

  @Test
  void otherSystemsOperator_neitherCommandsNorHears() throws IOException, GeneralSecurityException {
    PercentageCommand command = command(1.0);
    RecordingReceiver boatmanHears = new RecordingReceiver();
    Connection boatman =
        broker.keep(
            transport(accessOf("boatman"), Topic.ANY_SYSTEM).connect("Remote", boatmanHears));
    assertThat(boatman.subscribe(Channels.ACTUATION)).isTrue();
    RecordingReceiver pilotHears = new RecordingReceiver();
    assertThat(connect("pilot", pilotHears).subscribe(Channels.ACTUATION)).isTrue();

    byte[] stop = frozen(new EmergencyStop().active(true)).serialize();
    try (RawClient cunning = new RawClient(TestAuthority.socket(directory), broker.port)) {
      assertThat(cunning.introduce("cunning", "boatman", "boatman")).isZero();
      cunning.publish("u2sa/cessna/emergency-stop/EmergencyStop", stop, 0);
      awaitLog("message refused, it belongs to another system", "\"boatman\"");
    }
    publishUntilReceived(connect("control"), pilotHears, command);

    assertThat(boatmanHears.messages).isEmpty();
    assertThat(inbox.messages).noneMatch(EmergencyStop.class::isInstance);
  }

  @Test
  void removeUser_whileConnected_putsItOut() {
    RecordingReceiver pilot = new RecordingReceiver();
    connect("pilot", pilot);
    UserFile.write(directory.users(), List.of());
    pilot.awaitTrouble("lost");
    awaitLog("its user was changed or removed", "\"pilot\"");
  }

  @Test
  void start_onANetworkUnsecured_isRefusedUnlessSaidSo() {
    assertThatThrownBy(() -> broker.another(Map.of("BIND ADDRESS", "0.0.0.0")))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("BIND ADDRESS 0.0.0.0")
        .hasMessageContaining("ALLOW INSECURE NETWORK");
    broker.replace(Map.of("BIND ADDRESS", "0.0.0.0", "ALLOW INSECURE NETWORK", true));
    awaitLog("WARNING", "0.0.0.0");
  }

  @Test
  void start_keyReadableByOthers_isRefused() throws IOException {
    broker.manager().close();
    Files.setPosixFilePermissions(directory.key(), PosixFilePermissions.fromString("rw-r--r--"));
    assertThatThrownBy(() -> broker.another(Map.of("SECURITY DIRECTORY", folder.toString())))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("server-key.pem");
  }
}
