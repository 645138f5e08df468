package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.u2sa.core.communication.BrokerTraffic.command;
import static org.u2sa.core.communication.BrokerTraffic.frozen;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.util.Map;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.testkit.FreePort;

/** What remote services do while there is no broker: before it comes, and after it went. */
@Timeout(90)
class AbsentBrokerTest extends WiredClients {
  @Test
  void brokerThatForgot_getsTheRetainedMessagesOfBothSides() {
    GoalList mine = frozen(new GoalList());
    remote.publish(Channels.GOALS, mine);
    local.subscribe(Channels.GOALS);
    localInbox.awaitMessage(mine);

    broker.manager().close();
    remoteInbox.awaitTrouble("lost");
    GoalList newer = frozen(new GoalList(), 2);
    assertThat(remote.publish(Channels.GOALS, newer)).isFalse();
    local.close();
    broker.replace(Map.of());
    RecordingReceiver late = new RecordingReceiver();
    Connection lateOne = broker.local("Late", late);

    soon()
        .until(
            () -> {
              lateOne.subscribe(Channels.GOALS);
              return late.messages.contains(newer);
            });
  }

  @Test
  void close_whileTheBrokerIsGone_leavesNoThread() {
    broker.manager().close();
    remoteInbox.awaitTrouble("lost");

    remote.close();

    soon()
        .untilAsserted(
            () ->
                assertThat(Thread.getAllStackTraces())
                    .noneSatisfy(
                        (thread, at) -> assertThat(thread.getName()).contains(remote.instance())));
  }

  @Test
  void connect_beforeTheBroker_waitsForIt() {
    broker.manager().close();
    MqttTransport early = TestManager.transport(broker.port).waiting(20.0);

    CompletableFuture<Connection> connecting =
        CompletableFuture.supplyAsync(() -> early.connect("Early", new RecordingReceiver()));
    broker.replace(Map.of());

    Connection connection = connecting.join();
    assertThat(connection.publish(Channels.ACTUATION, command(1.0))).isTrue();
    connection.close();
  }

  @Test
  void connect_brokerNeverThere_givesUpAfterTheWait() {
    MqttTransport early = TestManager.transport(FreePort.find()).waiting(0.5);

    assertThatThrownBy(() -> early.connect("Early", new RecordingReceiver()))
        .isInstanceOf(CommunicationException.class)
        .hasMessageContaining("no Communication Manager at");
  }
}
