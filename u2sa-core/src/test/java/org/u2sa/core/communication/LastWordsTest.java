package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.XmlConfiguration;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.MqttTransport;
import org.u2sa.messages.MessageCodec;
import org.u2sa.messages.MessageTypes;
import org.u2sa.messages.PercentageCommand;
import org.u2sa.messages.U2SAData;

/** What is published just before the embedded broker ends. */
@Timeout(120)
class LastWordsTest {
  private static final MessageTypes TYPES = MessageTypes.standard();
  private static final Duration SOON = Duration.ofSeconds(30);
  private static final Channel<PercentageCommand> REPORTS =
      Channel.every("reports", PercentageCommand.TYPE);
  private static final int MANY = 300; // far more than the broker sends without acknowledgement

  private final List<String> log = new CopyOnWriteArrayList<>();
  private final RecordingReceiver inbox = new RecordingReceiver();
  private final List<Connection> connections = new ArrayList<>();
  private int port;
  private CommunicationManager manager;
  private Connection local;

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
    connections.add(local);
  }

  @AfterEach
  void stop() {
    connections.forEach(Connection::close);
    manager.close();
  }

  /** Returns when copies of the channel reach the new client. */
  private void join(int at, Channel<?> channel, U2SAData knock) {
    Connection remote =
        new MqttTransport("127.0.0.1", at, "cessna", new MessageCodec(TYPES))
            .connect("Remote", inbox);
    connections.add(remote);
    assertThat(remote.subscribe(channel)).isTrue();
    await()
        .atMost(SOON)
        .until(
            () -> {
              local.publish(channel, knock);
              return inbox.messages.contains(knock);
            });
  }

  private static <T extends U2SAData> T frozen(T message) {
    message.systemId("cessna");
    message.timestamp(1);
    message.freeze();
    return message;
  }

  private static PercentageCommand report(int number) {
    return frozen(PercentageCommand.of("RUDDER " + number, 1.0));
  }

  private List<PercentageCommand> publishMany() {
    List<PercentageCommand> sent =
        IntStream.range(0, MANY).mapToObj(LastWordsTest::report).toList();
    sent.forEach(report -> local.publish(REPORTS, report));
    return sent;
  }

  @Test
  void close_rightAfterMany_allHaveArrived() {
    join(port, REPORTS, report(-1));

    List<PercentageCommand> sent = publishMany();
    manager.close();

    assertThat(inbox.messages).containsSubsequence(sent);
    assertThat(manager.dropped()).isZero();
  }

  @Test
  void close_rightAfterNeutralCommands_allHaveArrived() {
    join(port, Channels.ACTUATION, frozen(PercentageCommand.of("KNOCK", 1.0)));
    List<PercentageCommand> neutral =
        List.of("AILERON", "ELEVATOR", "RUDDER", "THROTTLE", "BRAKES").stream()
            .map(actuator -> frozen(PercentageCommand.of(actuator, 0.0)))
            .toList();

    neutral.forEach(command -> local.publish(Channels.ACTUATION, command));
    manager.close();

    assertThat(inbox.messages).containsSubsequence(neutral);
  }

  @Test
  void close_clientTakesNothing_isCountedAndEndsAllTheSame() throws IOException {
    try (TcpRelay wire = new TcpRelay(port)) {
      join(wire.port(), REPORTS, report(-1));
      wire.goDead();

      publishMany();
      manager.close();

      assertThat(manager.dropped()).isPositive();
      assertThat(log).anyMatch(line -> line.contains("not taken by remote subscribers"));
    }
  }
}
