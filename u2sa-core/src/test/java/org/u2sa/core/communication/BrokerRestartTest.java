package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.time.Duration;
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
import org.u2sa.messages.GoalList;
import org.u2sa.messages.MessageCodec;
import org.u2sa.messages.MessageTypes;
import org.u2sa.messages.PercentageCommand;
import org.u2sa.messages.U2SAData;

/** The embedded broker's end and its successor in the same process. */
@Timeout(90)
class BrokerRestartTest {
  private static final MessageTypes TYPES = MessageTypes.standard();
  private static final Duration SOON = Duration.ofSeconds(30);

  private final List<String> log = new CopyOnWriteArrayList<>();
  private final RecordingReceiver localInbox = new RecordingReceiver();
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
    local = manager.transport().connect("Local", localInbox);
    remote = connect("Remote", remoteInbox);
  }

  private Connection connect(String name, RecordingReceiver inbox) {
    return new MqttTransport("127.0.0.1", port, "cessna", new MessageCodec(TYPES))
        .connect(name, inbox);
  }

  @AfterEach
  void stop() {
    remote.close();
    local.close();
    manager.close();
  }

  private static <T extends U2SAData> T frozen(T message) {
    message.systemId("cessna");
    message.timestamp(1);
    message.freeze();
    return message;
  }

  private static PercentageCommand command(double percent) {
    return frozen(PercentageCommand.of("RUDDER", percent));
  }

  private void publishUntilReceived(U2SAData message) {
    await()
        .atMost(SOON)
        .until(
            () -> {
              local.publish(Channels.ACTUATION, message);
              return remoteInbox.messages.contains(message);
            });
  }

  @Test
  void restartBroker_remoteComesBackAndIsGivenWhatIsRetained() {
    remote.subscribe(Channels.ACTUATION);
    publishUntilReceived(command(1.0));
    GoalList goals = frozen(new GoalList());
    local.publish(Channels.GOALS, goals);

    manager.restartBroker();

    publishUntilReceived(command(2.0));
    RecordingReceiver late = new RecordingReceiver();
    Connection lateOne = connect("Late", late);
    lateOne.subscribe(Channels.GOALS);
    await().atMost(SOON).until(() -> late.messages.contains(goals));
    lateOne.close();
    assertThat(log).anyMatch(line -> line.contains("started anew"));
  }

  @Test
  void restartBroker_servicesOfTheProcessNoticeNothing() {
    RecordingReceiver other = new RecordingReceiver();
    Connection subscriber = manager.transport().connect("Other", other);
    subscriber.subscribe(Channels.ACTUATION);

    local.publish(Channels.ACTUATION, command(1.0));
    manager.restartBroker();
    local.publish(Channels.ACTUATION, command(2.0));

    assertThat(other.messages).containsExactly(command(1.0), command(2.0));
    assertThat(other.troubles).isEmpty();
    assertThat(local.refused()).isZero();
  }
}
