package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.LockSupport;
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
import org.u2sa.messages.U2SAData;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.contract.StopCommand;

/** What remote services notice of a link or a broker that goes and comes back. */
@Timeout(90)
class BrokenLinkTest {
  private static final MessageTypes TYPES = MessageTypes.standard();
  private static final Duration SOON = Duration.ofSeconds(15);

  private final List<String> log = new CopyOnWriteArrayList<>();
  private final RecordingReceiver localInbox = new RecordingReceiver();
  private final RecordingReceiver remoteInbox = new RecordingReceiver();
  private int port;
  private TcpRelay wire;
  private CommunicationManager manager;
  private Connection local;
  private Connection remote;
  private int numbered; // commands published, each with its number

  @BeforeEach
  void start() throws IOException {
    port = freePort();
    manager = manager();
    wire = new TcpRelay(port);
    local = manager.transport().connect("Local", localInbox);
    remote = transport(wire.port()).connect("Remote", remoteInbox);
  }

  @AfterEach
  void stop() {
    remote.close();
    local.close();
    wire.close();
    manager.close();
  }

  private static int freePort() throws IOException {
    try (ServerSocket probe = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return probe.getLocalPort();
    }
  }

  private CommunicationManager manager() {
    return CommunicationManager.start(
        "cessna",
        XmlConfiguration.inMemory("test", Map.of("COMMUNICATION MANAGER PORT", port)),
        TYPES,
        log::add);
  }

  private static MqttTransport transport(int port) {
    return new MqttTransport("127.0.0.1", port, "cessna", new MessageCodec(TYPES));
  }

  private static <T extends U2SAData> T frozen(T message, long timestamp) {
    message.systemId("cessna");
    message.timestamp(timestamp);
    message.freeze();
    return message;
  }

  private static PercentageCommand command(double percent) {
    return frozen(PercentageCommand.of("RUDDER", percent), 1);
  }

  private static void awaitWord(RecordingReceiver of, String word) {
    await().atMost(SOON).until(() -> of.troubles.stream().anyMatch(line -> line.contains(word)));
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
  void linkCut_brokerSaysTheWillOnce_withTheInstance() {
    local.subscribe(Channels.HEALTH);
    RecordingReceiver witness = new RecordingReceiver();
    Connection other = transport(port).connect("Witness", witness);
    other.subscribe(Channels.HEALTH);

    wire.cut();

    await().atMost(SOON).until(() -> !localInbox.messages.isEmpty() && !witness.messages.isEmpty());
    other.close();
    assertThat(localInbox.messages).hasSize(1).isEqualTo(witness.messages);
    ConnectionLost will = (ConnectionLost) localInbox.messages.get(0);
    assertThat(will.serviceName()).isEqualTo("Remote");
    assertThat(will.instance()).contains(remote.instance());
    assertThat(will.status()).isEqualTo(ServiceStatus.FAILED);
    assertThat(will.lastError()).contains("connection lost");
  }

  @Test
  void linkCut_whatWasSentMeanwhile_isCountedAsMissedByWhoCouldNotHearIt() {
    remote.subscribe(Channels.ACTUATION);
    publishUntilOneMoreIsReceived();
    wire.cut();
    awaitWord(remoteInbox, "lost");
    for (int i = 0; i < 7; i++) {
      publishNext();
    }
    wire.restore();
    awaitWord(remoteInbox, "restored");
    publishUntilOneMoreIsReceived();
    publishNext();
    await()
        .atMost(SOON)
        .until(() -> number(remoteInbox.messages.get(remoteInbox.messages.size() - 1)) == numbered);

    int sinceTheFirstReceived = numbered - (int) number(remoteInbox.messages.get(0)) + 1;
    assertThat(remote.missed())
        .isEqualTo(sinceTheFirstReceived - remoteInbox.messages.size())
        .isGreaterThanOrEqualTo(7);
    assertThat(local.missed()).isZero();
  }

  private void publishNext() {
    local.publish(Channels.ACTUATION, command(++numbered));
  }

  private static double number(U2SAData command) {
    return ((PercentageCommand) command).percentage();
  }

  private void publishUntilOneMoreIsReceived() {
    int before = remoteInbox.messages.size();
    await()
        .atMost(SOON)
        .until(
            () -> {
              publishNext();
              return remoteInbox.messages.size() > before;
            });
  }

  @Test
  void linkCut_whatItCouldNotSend_isCountedAsMissedByTheOtherSide() {
    local.subscribe(Channels.STOP);
    remote.publish(Channels.STOP, frozen(new StopCommand().serviceName("first"), 1));
    await().atMost(SOON).until(() -> localInbox.messages.size() == 1);
    wire.cut();
    awaitWord(remoteInbox, "lost");
    for (int i = 0; i < 5; i++) {
      remote.publish(Channels.STOP, frozen(new StopCommand().serviceName("lost"), 2));
    }
    wire.restore();
    awaitWord(remoteInbox, "restored");
    remote.publish(Channels.STOP, frozen(new StopCommand().serviceName("last"), 3));
    await().atMost(SOON).until(() -> localInbox.messages.size() == 2);

    assertThat(local.missed()).isEqualTo(5);
  }

  @Test
  void close_cleanly_noWillIsSaid() {
    local.subscribe(Channels.HEALTH);
    remote.close();
    Connection other = transport(port).connect("Witness", new RecordingReceiver());
    local.subscribe(Channels.ACTUATION);

    await()
        .until(
            () -> {
              other.publish(Channels.ACTUATION, command(3.0));
              return !localInbox.messages.isEmpty();
            });

    other.close();
    assertThat(localInbox.messages).noneMatch(ConnectionLost.class::isInstance);
  }

  @Test
  void linkCutAndRestored_subscriptionsAreBackAndNothingIsTwice() {
    remote.subscribe(Channels.ACTUATION);
    publishUntilReceived(command(1.0));

    wire.cut();
    awaitWord(remoteInbox, "lost");
    assertThat(remote.publish(Channels.STOP, command(2.0))).isFalse();
    wire.restore();
    awaitWord(remoteInbox, "restored, subscriptions too");
    remoteInbox.messages.clear();
    local.publish(Channels.ACTUATION, command(3.0));
    local.publish(Channels.ACTUATION, command(4.0));

    await().until(() -> remoteInbox.messages.contains(command(4.0)));
    assertThat(remoteInbox.messages).containsExactly(command(3.0), command(4.0));
    assertThat(remote.refused()).isEqualTo(1);
    assertThat(remoteInbox.troubles).anyMatch(line -> line.contains("1 messages could not"));
  }

  @Test
  void subscribe_whileTheLinkIsBroken_beginsWhenItIsBack() {
    wire.cut();
    awaitWord(remoteInbox, "lost");

    assertThat(remote.subscribe(Channels.ACTUATION)).isTrue();
    wire.restore();

    publishUntilReceived(command(1.0));
  }

  @Test
  void linkDeadWithoutAWord_isFoundWithinSeconds_hereAndByTheBroker() {
    local.subscribe(Channels.HEALTH);

    wire.goDead();

    await().atMost(Duration.ofSeconds(6)).until(() -> !localInbox.messages.isEmpty());
    await()
        .atMost(Duration.ofSeconds(6))
        .until(() -> remoteInbox.troubles.stream().anyMatch(line -> line.contains("lost")));
    wire.restore();
    awaitWord(remoteInbox, "restored");
  }

  @Test
  void linkDead_messagesWithoutConfirmationAreCounted() {
    wire.goDead();
    int sent = 0;
    while (remoteInbox.troubles.isEmpty()) {
      remote.publish(Channels.STOP, frozen(new StopCommand(), ++sent));
      LockSupport.parkNanos(10_000_000); // not as fast as the processor can
    }

    assertThat(remote.refused()).isGreaterThanOrEqualTo(sent - 1);
    wire.restore();
  }

  @Test
  void brokerThatForgot_getsTheRetainedMessagesOfBothSides() {
    GoalList mine = frozen(new GoalList(), 1);
    remote.publish(Channels.GOALS, mine);
    local.subscribe(Channels.GOALS);
    await().until(() -> localInbox.messages.contains(mine));

    manager.close();
    awaitWord(remoteInbox, "lost");
    GoalList newer = frozen(new GoalList(), 2);
    assertThat(remote.publish(Channels.GOALS, newer)).isFalse();
    local.close();
    manager = manager();
    RecordingReceiver late = new RecordingReceiver();
    Connection lateOne = manager.transport().connect("Late", late);

    await()
        .atMost(SOON)
        .until(
            () -> {
              lateOne.subscribe(Channels.GOALS);
              return late.messages.contains(newer);
            });
    lateOne.close();
  }

  @Test
  void retainedMessageOfAnother_isNotOverwrittenAndNotHeardTwice() {
    GoalList old = frozen(new GoalList(), 1);
    GoalList newer = frozen(new GoalList(), 2);
    remote.publish(Channels.GOALS, old);
    remote.subscribe(Channels.GOALS);
    local.subscribe(Channels.GOALS);
    await().atMost(SOON).until(() -> localInbox.messages.contains(old));
    await()
        .atMost(SOON)
        .until(
            () -> {
              local.publish(Channels.GOALS, newer);
              return remoteInbox.messages.contains(newer);
            });
    GoalList newest = frozen(new GoalList(), 3); // once, when nothing is on its way any more
    local.publish(Channels.GOALS, newest);
    await().atMost(SOON).until(() -> remoteInbox.messages.contains(newest));
    wire.cut();
    awaitWord(remoteInbox, "lost");
    remoteInbox.messages.clear();
    wire.restore();
    awaitWord(remoteInbox, "restored");
    remote.subscribe(Channels.ACTUATION);
    publishUntilReceived(command(1.0));

    assertThat(remoteInbox.messages).doesNotHaveAnyElementsOfTypes(GoalList.class);
    assertThat(localInbox.messages.get(localInbox.messages.size() - 1)).isEqualTo(newest);
  }

  @Test
  void close_whileTheBrokerIsGone_leavesNoThread() {
    manager.close();
    awaitWord(remoteInbox, "lost");

    remote.close();

    await()
        .atMost(SOON)
        .untilAsserted(
            () ->
                assertThat(Thread.getAllStackTraces())
                    .noneSatisfy(
                        (thread, at) -> assertThat(thread.getName()).contains(remote.instance())));
  }

  @Test
  void connect_beforeTheBroker_waitsForIt() throws IOException {
    manager.close();
    port = freePort();
    MqttTransport early = transport(port).waiting(20.0);

    CompletableFuture<Connection> connecting =
        CompletableFuture.supplyAsync(() -> early.connect("Early", new RecordingReceiver()));
    manager = manager();

    Connection connection = connecting.join();
    assertThat(connection.publish(Channels.ACTUATION, command(1.0))).isTrue();
    connection.close();
  }

  @Test
  void connect_brokerNeverThere_givesUpAfterTheWait() throws IOException {
    MqttTransport early = transport(freePort()).waiting(0.5);

    assertThatThrownBy(() -> early.connect("Early", new RecordingReceiver()))
        .isInstanceOf(CommunicationException.class)
        .hasMessageContaining("no Communication Manager at");
  }
}
