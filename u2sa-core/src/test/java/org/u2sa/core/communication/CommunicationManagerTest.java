package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.eclipse.paho.client.mqttv3.MqttClient;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.eclipse.paho.client.mqttv3.persist.MemoryPersistence;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.XmlConfiguration;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.MqttTransport;
import org.u2sa.messages.GoalList;
import org.u2sa.messages.MessageCodec;
import org.u2sa.messages.MessageTypes;
import org.u2sa.messages.PercentageCommand;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.U2SAData;

@Timeout(60)
class CommunicationManagerTest {
  private static final MessageTypes TYPES = MessageTypes.standard();

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
    manager = start(Map.of());
    local = manager.transport().connect("Local", localInbox);
    remote =
        new MqttTransport("127.0.0.1", port, "cessna", new MessageCodec(TYPES))
            .connect("Remote", remoteInbox);
  }

  private CommunicationManager start(Map<String, Object> variables) {
    Map<String, Object> all = new HashMap<>(variables);
    all.putIfAbsent("COMMUNICATION MANAGER PORT", port);
    return CommunicationManager.start(
        "cessna", XmlConfiguration.inMemory("test", all), TYPES, log::add);
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

  /**
   * Publishes until it arrives: the broker tells its listeners of a new subscription a moment after
   * it confirmed it.
   */
  private static void publishUntilReceived(
      Connection from, RecordingReceiver to, U2SAData message) {
    await()
        .until(
            () -> {
              from.publish(Channels.ACTUATION, message);
              return to.messages.contains(message);
            });
  }

  @Test
  void publish_locally_reachesRemoteSubscribersAsEqualMessage() {
    remote.subscribe(Channels.ACTUATION);

    publishUntilReceived(local, remoteInbox, frozen(PercentageCommand.of("RUDDER", 5.0)));

    assertThat(remoteInbox.troubles).isEmpty();
  }

  @Test
  void publish_remotely_reachesLocalSubscribers() {
    local.subscribe(Channels.ACTUATION);
    PercentageCommand command = frozen(PercentageCommand.of("RUDDER", 5.0));

    remote.publish(Channels.ACTUATION, command);

    await().until(() -> localInbox.messages.contains(command));
  }

  @Test
  void publish_remotely_isNotEchoedToTheBrokerAgain() {
    local.subscribe(Channels.ACTUATION);
    remote.subscribe(Channels.ACTUATION);
    PercentageCommand first = frozen(PercentageCommand.of("RUDDER", 1.0));
    PercentageCommand last = frozen(PercentageCommand.of("RUDDER", 2.0));

    remote.publish(Channels.ACTUATION, first);
    remote.publish(Channels.ACTUATION, last);

    await().until(() -> remoteInbox.messages.contains(last) && localInbox.messages.contains(last));
    assertThat(remoteInbox.messages).containsExactly(first, last);
    assertThat(localInbox.messages).containsExactly(first, last);
  }

  @Test
  void subscribe_remotelyAndLate_getsRetainedMessage() {
    GoalList goals = frozen(new GoalList());
    local.publish(Channels.GOALS, goals);

    await()
        .until(
            () -> {
              remote.subscribe(Channels.GOALS);
              return remoteInbox.messages.contains(goals);
            });
  }

  @Test
  void publish_anotherSystemsMessage_isNotHeard() {
    local.subscribe(Channels.STATE);
    Connection other =
        new MqttTransport("127.0.0.1", port, "boat", new MessageCodec(TYPES))
            .connect("Remote", new RecordingReceiver());
    StateInformation mine = frozen(new StateInformation().sensorName("a").x(1.0));

    other.publish(Channels.STATE, frozen(new StateInformation().sensorName("boat").x(2.0)));
    other.close();
    remote.publish(Channels.STATE, mine);

    await().until(() -> localInbox.messages.contains(mine));
    assertThat(localInbox.messages).containsExactly(mine);
  }

  @Test
  void publish_garbageFromAForeignClient_isRefusedAndLoggedAndTheRestGoesOn() throws MqttException {
    local.subscribe(Channels.ACTUATION);
    MqttClient foreign =
        new MqttClient("tcp://127.0.0.1:" + port, "foreign", new MemoryPersistence());
    foreign.connect();
    foreign.publish("u2sa/cessna/actuation/ActuatorCommand", new byte[] {1, 2, 3}, 1, false);
    foreign.publish("u2sa/cessna/actuation", new byte[] {1, 2, 3}, 1, false);
    foreign.publish("elsewhere", new byte[0], 1, false);
    foreign.disconnect();
    foreign.close();
    PercentageCommand command = frozen(PercentageCommand.of("RUDDER", 5.0));

    remote.publish(Channels.ACTUATION, command);

    await().until(() -> localInbox.messages.contains(command));
    assertThat(localInbox.messages).containsExactly(command);
    assertThat(log)
        .anyMatch(
            line ->
                line.contains("u2sa/cessna/actuation/ActuatorCommand")
                    && line.contains("cannot be read"));
  }

  @Test
  void connect_foreignClientWithoutAName_isTaken() throws MqttException {
    MqttClient client = new MqttClient("tcp://127.0.0.1:" + port, "", new MemoryPersistence());
    client.connect(); // as mosquitto_sub does; throws if the broker refuses
    assertThat(client.isConnected()).isTrue();
    client.disconnect();
    client.close();
  }

  @Test
  void start_portTaken_saysWhichAndWhatToDo() {
    assertThatThrownBy(() -> start(Map.of()))
        .isInstanceOf(CommunicationException.class)
        .hasMessageContaining("127.0.0.1:" + port)
        .hasMessageContaining("COMMUNICATION MANAGER PORT");
  }

  @Test
  void start_externalBroker_servicesTalkThroughIt() {
    try (CommunicationManager external = start(Map.of("BROKER", "external"))) {
      RecordingReceiver inbox = new RecordingReceiver();
      Connection connection = external.transport().connect("External", inbox);
      connection.subscribe(Channels.ACTUATION);
      PercentageCommand command = frozen(PercentageCommand.of("RUDDER", 5.0));

      publishUntilReceived(remote, inbox, command);

      assertThat(external.address()).isEmpty();
      connection.close();
    }
  }

  @Test
  void start_externalBrokerAbsent_saysWhereItLooked() throws IOException {
    int unused;
    try (ServerSocket probe = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      unused = probe.getLocalPort();
    }
    assertThatThrownBy(
            () -> start(Map.of("BROKER", "external", "COMMUNICATION MANAGER PORT", unused)))
        .isInstanceOf(CommunicationException.class)
        .hasMessageContaining("no Communication Manager at tcp://localhost:" + unused);
  }

  @Test
  void close_brokerGone_remoteClientSaysSo() {
    manager.close();

    await()
        .untilAsserted(
            () -> assertThat(remoteInbox.troubles).anyMatch(line -> line.contains("lost")));
    manager = start(Map.of());
    await()
        .atMost(Duration.ofSeconds(20))
        .untilAsserted(
            () -> assertThat(remoteInbox.troubles).anyMatch(line -> line.contains("restored")));
  }
}
