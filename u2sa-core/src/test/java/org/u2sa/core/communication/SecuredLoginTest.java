package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.u2sa.core.communication.BrokerTraffic.command;
import static org.u2sa.core.communication.BrokerTraffic.publishUntilReceived;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.mqtt.BrokerAccess;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.MessageCodec;

/** Whom the embedded broker lets in, and which broker a client trusts. */
@Timeout(120)
class SecuredLoginTest extends SecuredClients {
  @TempDir static Path otherFolder;

  @Test
  void connect_withAnotherUsersClientId_isRefusedAndTheFirstStays()
      throws IOException, GeneralSecurityException {
    try (RawClient first = new RawClient(TestAuthority.socket(directory), broker.port);
        RawClient second = new RawClient(TestAuthority.socket(directory), broker.port)) {
      assertThat(first.introduce("twin", "sensor", "sensor")).isZero();
      assertThat(second.introduce("twin", "boatman", "boatman")).isEqualTo(2);
      assertThat(first.subscribe("u2sa/cessna/state/#")).isZero();
    }
    awaitLog("log-in refused, the client ID belongs to another user", "\"boatman\"");
  }

  @Test
  void connect_asAClientOfAnotherSystem_isRefused() {
    assertThatThrownBy(() -> connect("boatman"))
        .isInstanceOf(CommunicationException.class)
        .hasMessageContaining("Not authorized");
    awaitLog("log-in refused, it belongs to another system", "\"boatman\"");
  }

  @Test
  void connect_observerWhoseWillItsRoleForbids_isLetInWithoutIt() {
    RecordingReceiver screenHears = new RecordingReceiver();
    PercentageCommand command = command(1.0);

    assertThat(connect("screen", screenHears).subscribe(Channels.ACTUATION)).isTrue();
    publishUntilReceived(connect("control"), screenHears, command);
    awaitLog("will refused, role observer may not publish on health", "\"screen\"");
  }

  @Test
  void connect_wrongPassword_isRefusedAndLoggedWithUserAndAddress() throws IOException {
    Files.writeString(folder.resolve("pilot.password"), "guess\n");

    assertThatThrownBy(() -> connect("pilot"))
        .isInstanceOf(CommunicationException.class)
        .hasMessageContaining("ssl://localhost:" + broker.port)
        .hasMessageContaining("Bad user name or password")
        .hasMessageContaining("user \"pilot\" is unknown there, or the password is wrong")
        .hasMessageNotContaining("is it running");

    awaitLog("log-in refused, wrong password", "\"pilot\"", "127.0.0.1");
  }

  @Test
  void connect_rightPasswordAfterAFloodOfWrongOnes_isKnownAtOnceIfItCameBefore()
      throws IOException {
    connect("pilot").close();
    BrokerAccess right = accessOf("pilot");
    Files.writeString(folder.resolve("pilot.password"), "guess\n");
    soon()
        .until(
            () -> {
              assertThatThrownBy(() -> connect("pilot")).isInstanceOf(CommunicationException.class);
              return broker.log.stream()
                  .anyMatch(line -> line.contains("too soon after a wrong password"));
            });

    broker.keep(transport(right, "cessna").connect("Remote", new RecordingReceiver()));
  }

  @Test
  void connect_withoutUser_isRefused() {
    BrokerAccess nobody = BrokerAccess.of("", "", true, directory.authority().toString());
    assertThatThrownBy(() -> transport(nobody, "cessna").connect("Remote", inbox))
        .isInstanceOf(CommunicationException.class)
        .hasMessageContaining("it admits users only: --user, --password-file and --ca");
    awaitLog("log-in refused, it gives no user name");
  }

  @Test
  void connect_withoutEncryption_isRefused() {
    MqttTransport plain = transport(BrokerAccess.open(), "cessna").as("", new char[0]).waiting(0.0);
    awaitDistrust(plain, "it is encrypted and admits users only: --user, --password-file and --ca");
  }

  @Test
  void connect_brokerOfAnotherAuthority_isNotTrusted()
      throws IOException, InterruptedException, GeneralSecurityException {
    SecurityDirectory other = TestAuthority.in(otherFolder);
    BrokerAccess access =
        BrokerAccess.of(
            "pilot",
            folder.resolve("pilot.password").toString(),
            true,
            other.authority().toString());
    awaitDistrust(transport(access, "cessna").waiting(0.0), "PKIX");
    awaitDistrust(transport(access, "cessna").waiting(0.0), "is not from the authority of --ca");
  }

  @Test
  void connect_certificateOfAnotherName_isNotTrusted() {
    MqttTransport otherName =
        new MqttTransport(
            "127.0.0.2",
            broker.port,
            "cessna",
            new MessageCodec(StandardTypes.registry()),
            accessOf("pilot"));
    broker.replace(Map.of("SECURITY DIRECTORY", folder.toString(), "BIND ADDRESS", "0.0.0.0"));
    awaitDistrust(otherName, "No subject alternative names matching IP address 127.0.0.2");
    awaitDistrust(otherName, "make one that has it: ./u2sa security certificate 127.0.0.2");
  }

  /** An attempt may also end because it took too long. */
  private void awaitDistrust(MqttTransport transport, String reason) {
    soon()
        .untilAsserted(
            () ->
                assertThatThrownBy(() -> transport.connect("Remote", inbox))
                    .isInstanceOf(CommunicationException.class)
                    .hasMessageContaining(reason));
  }

  @Test
  void brokerTransport_ofTheBrokersOwnProcess_needsNoAccountAndMayDoEverything() {
    Transport own = broker.manager().brokerTransport().orElseThrow();
    Connection service = broker.keep(own.connect("Own", new RecordingReceiver()));
    StopCommand stop = new StopCommand().stopAll(false).serviceName("Control");
    stop.systemId("cessna");
    stop.timestamp(1L);
    stop.freeze();

    service.publish(Channels.STOP, stop);

    inbox.awaitMessage(stop);
  }
}
