package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.XmlConfiguration;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.MqttTransport;
import org.u2sa.messages.MessageCodec;
import org.u2sa.messages.MessageTypes;
import org.u2sa.messages.PercentageCommand;
import org.u2sa.messages.U2SAData;
import org.u2sa.messages.contract.FunctionalityResponse;

/** What the broker and its clients do when something on the way fails. */
@Timeout(60)
class BrokerTroubleTest {
  private static final MessageTypes TYPES = MessageTypes.standard();

  private final List<String> log = new CopyOnWriteArrayList<>();
  private final RecordingReceiver remoteInbox = new RecordingReceiver();
  private int port;
  private CommunicationManager manager;
  private Connection local;
  private Connection remote;

  @BeforeEach
  void start() throws IOException {
    try (ServerSocket probe = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      port = probe.getLocalPort();
    }
    manager =
        CommunicationManager.start(
            "cessna",
            XmlConfiguration.inMemory("test", Map.of("COMMUNICATION MANAGER PORT", port)),
            TYPES,
            log::add);
    local = manager.transport().connect("Local", new RecordingReceiver());
    remote =
        new MqttTransport("127.0.0.1", port, "cessna", new MessageCodec(TYPES))
            .connect("Remote", remoteInbox);
  }

  @AfterEach
  void stop() {
    remote.close();
    local.close();
    manager.close();
  }

  private static PercentageCommand command(String actuator) {
    PercentageCommand command = PercentageCommand.of(actuator, 1.0);
    command.systemId("cessna");
    command.timestamp(1);
    command.freeze();
    return command;
  }

  private void publishUntilReceived(U2SAData message) {
    await()
        .until(
            () -> {
              local.publish(Channels.ACTUATION, message);
              return remoteInbox.messages.contains(message);
            });
  }

  @Test
  void publish_messageThatCannotBeEncoded_isCountedAndTheNextOnesGoOut() {
    remote.subscribe(Channels.ACTUATION);
    publishUntilReceived(command("first"));

    FunctionalityResponse tooLong = new FunctionalityResponse().serviceName("Local");
    tooLong.publishes(Collections.nCopies(40, "x".repeat(60_000)));
    tooLong.subscribes(List.of());
    tooLong.freeze();
    remote.subscribe(Channels.FUNCTIONALITY);
    await()
        .until(
            () -> {
              local.publish(Channels.FUNCTIONALITY, tooLong);
              return manager.dropped() > 0;
            });

    publishUntilReceived(command("next"));
    assertThat(log).first().asString().contains("functionality").contains("dropped");
  }

  @Test
  void publish_whileTheBrokerIsGone_isRefusedAndCounted() {
    manager.close();
    await().until(() -> remoteInbox.troubles.stream().anyMatch(line -> line.contains("lost")));

    assertThat(remote.publish(Channels.ACTUATION, command("RUDDER"))).isFalse();

    assertThat(remote.refused()).isEqualTo(1);
  }
}
