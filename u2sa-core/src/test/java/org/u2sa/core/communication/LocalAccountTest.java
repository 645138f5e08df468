package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Map;
import java.util.concurrent.FutureTask;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.mqtt.AccountFolders;
import org.u2sa.interfaces.mqtt.LocalToken;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.MessageCodec;

/** Who of a shared machine may command a vehicle that has no users. */
@Timeout(60)
@DisabledOnOs(OS.WINDOWS)
class LocalAccountTest {
  private final RecordingReceiver inbox = new RecordingReceiver();
  private TestManager broker;
  private Path token;

  @BeforeEach
  void start() {
    broker = new TestManager(Map.of("LOCAL COMMANDS", "account"));
    token =
        AccountFolders.ofProcess()
            .all()
            .get(0)
            .resolve(LocalToken.fileName("127.0.0.1", broker.port));
    broker.local("Local", inbox).subscribe(Channels.STOP);
  }

  @AfterEach
  void stop() {
    broker.close();
  }

  private static StopCommand stop(String service) {
    StopCommand stop = new StopCommand().stopAll(false).serviceName(service);
    stop.systemId("cessna");
    stop.timestamp(1L);
    stop.freeze();
    return stop;
  }

  @Test
  void token_ofARunningBroker_isItsAccountsAloneAndGoneAfterwards() throws IOException {
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(token)))
        .isEqualTo("rw-------");
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(token.getParent())))
        .isEqualTo("rwx------");
    String first = Files.readString(token);
    broker.replace(Map.of("LOCAL COMMANDS", "account"));
    assertThat(Files.readString(token)).isNotEqualTo(first).hasSizeGreaterThan(40);
    broker.manager().close();
    assertThat(token).doesNotExist();
  }

  @Test
  void anonymous_onLoopback_listensAndAsksButDoesNotCommand() throws IOException {
    try (RawClient other = new RawClient(broker.port).introduced("somebody")) {
      assertThat(other.subscribe("u2sa/#")).isLessThan(3);
      other.publish("u2sa/cessna/stop/StopCommand", stop("PathPlanner").serialize(), 1);
      Connection own = broker.remote("Own", new RecordingReceiver());
      own.publish(Channels.STOP, stop("Control"));

      inbox.awaitMessage(stop("Control"));
      assertThat(inbox.messages).doesNotContain(stop("PathPlanner"));
    }
    assertThat(broker.log).anyMatch(line -> line.contains("stop") && line.contains("somebody"));
  }

  @Test
  void wrongToken_isRefused() throws IOException {
    try (RawClient other = new RawClient(broker.port)) {
      assertThat(other.introduce("guess", "local", "guessed")).isNotZero();
    }
  }

  @Test
  void another_onATakenPort_leavesTheFirstOnesToken() throws IOException {
    String first = Files.readString(token);

    assertThatThrownBy(() -> broker.another(Map.of("LOCAL COMMANDS", "account")))
        .isInstanceOf(CommunicationException.class);

    assertThat(Files.readString(token)).isEqualTo(first);
  }

  @Test
  @EnabledOnOs(OS.LINUX) // where all of 127.0.0.0/8 is there without being configured
  void token_toAnotherLoopbackAddressWhereAnyAccountMayListen_isNotTold() throws Exception {
    try (ServerSocket impostor = new ServerSocket()) {
      impostor.bind(new InetSocketAddress("127.0.0.2", broker.port));
      FutureTask<String> heard = new FutureTask<>(() -> firstPacket(impostor));
      new Thread(heard).start();
      MqttTransport transport =
          new MqttTransport(
                  "127.0.0.2", broker.port, "cessna", new MessageCodec(StandardTypes.registry()))
              .waiting(0.1);
      assertThatThrownBy(() -> transport.connect("Own", inbox))
          .isInstanceOf(CommunicationException.class);
      assertThat(heard.get()).contains("MQTT").doesNotContain(Files.readString(token).trim());
    }
  }

  private static String firstPacket(ServerSocket impostor) throws IOException {
    try (Socket victim = impostor.accept()) {
      byte[] packet = new byte[1_024];
      int length = victim.getInputStream().read(packet);
      return new String(packet, 0, length, StandardCharsets.ISO_8859_1);
    }
  }

  @Test
  void token_openToOthers_isNotUsed() throws IOException {
    Files.setPosixFilePermissions(token, PosixFilePermissions.fromString("rw-r--r--"));
    Connection own = broker.remote("Own", new RecordingReceiver());
    own.publish(Channels.STOP, stop("Control"));
    Files.setPosixFilePermissions(token, PosixFilePermissions.fromString("rw-------"));
    Connection closed = broker.remote("Closed", new RecordingReceiver());
    closed.publish(Channels.STOP, stop("PathPlanner"));

    inbox.awaitMessage(stop("PathPlanner"));
    assertThat(inbox.messages).doesNotContain(stop("Control"));
  }
}
