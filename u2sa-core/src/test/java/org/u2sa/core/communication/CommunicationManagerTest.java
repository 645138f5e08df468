package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.u2sa.core.communication.BrokerTraffic.command;
import static org.u2sa.core.communication.BrokerTraffic.frozen;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.util.Map;
import org.eclipse.paho.client.mqttv3.MqttClient;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.eclipse.paho.client.mqttv3.persist.MemoryPersistence;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.testkit.FreePort;

/**
 * What goes between the clients of a Communication Manager, and what one says that cannot start.
 */
@Timeout(90)
class CommunicationManagerTest extends TwoClients {
  @Test
  void publish_locally_reachesRemoteSubscribersAsEqualMessage() {
    remote.subscribe(Channels.ACTUATION);

    publishUntilReceived(command(5.0));

    assertThat(remoteInbox.troubles).isEmpty();
  }

  @Test
  void publish_remotely_reachesLocalSubscribers() {
    local.subscribe(Channels.ACTUATION);
    PercentageCommand command = command(5.0);

    remote.publish(Channels.ACTUATION, command);

    localInbox.awaitMessage(command);
  }

  @Test
  void publish_remotely_isNotEchoedToTheBrokerAgain() {
    local.subscribe(Channels.ACTUATION);
    remote.subscribe(Channels.ACTUATION);
    PercentageCommand first = command(1.0);
    PercentageCommand last = command(2.0);

    remote.publish(Channels.ACTUATION, first);
    remote.publish(Channels.ACTUATION, last);

    remoteInbox.awaitMessage(last);
    localInbox.awaitMessage(last);
    assertThat(remoteInbox.messages).containsExactly(first, last);
    assertThat(localInbox.messages).containsExactly(first, last);
  }

  @Test
  void subscribe_remotelyAndLate_getsRetainedMessage() {
    GoalList goals = frozen(new GoalList());
    local.publish(Channels.GOALS, goals);

    soon()
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
        new MqttTransport(
                "127.0.0.1", broker.port, "boat", new MessageCodec(StandardTypes.registry()))
            .connect("Remote", new RecordingReceiver());
    StateInformation mine = frozen(new StateInformation().sensorName("a").x(1.0));

    other.publish(Channels.STATE, frozen(new StateInformation().sensorName("boat").x(2.0)));
    other.close();
    remote.publish(Channels.STATE, mine);

    localInbox.awaitMessage(mine);
    assertThat(localInbox.messages).containsExactly(mine);
  }

  @Test
  void publish_garbageFromAForeignClient_isRefusedAndLoggedAndTheRestGoesOn() throws MqttException {
    local.subscribe(Channels.ACTUATION);
    MqttClient foreign =
        new MqttClient("tcp://127.0.0.1:" + broker.port, "foreign", new MemoryPersistence());
    foreign.connect();
    foreign.publish("u2sa/cessna/actuation/ActuatorCommand", new byte[] {1, 2, 3}, 1, false);
    foreign.publish("u2sa/cessna/actuation", new byte[] {1, 2, 3}, 1, false);
    foreign.publish("elsewhere", new byte[0], 1, false);
    foreign.disconnect();
    foreign.close();
    PercentageCommand command = command(5.0);

    remote.publish(Channels.ACTUATION, command);

    localInbox.awaitMessage(command);
    assertThat(localInbox.messages).containsExactly(command);
    assertThat(broker.log)
        .anyMatch(
            line ->
                line.contains("u2sa/cessna/actuation/ActuatorCommand")
                    && line.contains("cannot be read"));
  }

  @Test
  void connect_foreignClientWithoutAName_isTaken() throws MqttException {
    MqttClient client =
        new MqttClient("tcp://127.0.0.1:" + broker.port, "", new MemoryPersistence());
    client.connect(); // as mosquitto_sub does; throws if the broker refuses
    assertThat(client.isConnected()).isTrue();
    client.disconnect();
    client.close();
  }

  @Test
  void start_portTaken_saysWhichAndWhatToDo() {
    assertThatThrownBy(() -> broker.another(Map.of()))
        .isInstanceOf(CommunicationException.class)
        .hasMessageContaining("127.0.0.1:" + broker.port)
        .hasMessageContaining("COMMUNICATION MANAGER PORT");
  }

  @Test
  void start_externalBroker_servicesTalkThroughIt() {
    try (CommunicationManager external = broker.another(Map.of("BROKER", "external"))) {
      RecordingReceiver inbox = new RecordingReceiver();
      Connection connection = external.transport().connect("External", inbox);
      connection.subscribe(Channels.ACTUATION);
      PercentageCommand command = command(5.0);

      BrokerTraffic.publishUntilReceived(remote, inbox, command);

      assertThat(external.address()).isEmpty();
      connection.close();
    }
  }

  @Test
  void start_externalBrokerAbsent_saysWhereItLooked() {
    int unused = FreePort.find();
    assertThatThrownBy(
            () ->
                broker.another(Map.of("BROKER", "external", "COMMUNICATION MANAGER PORT", unused)))
        .isInstanceOf(CommunicationException.class)
        .hasMessageContaining("no Communication Manager at tcp://localhost:" + unused);
  }

  @Test
  void close_brokerGone_remoteClientSaysSo() {
    broker.manager().close();
    remoteInbox.awaitTrouble("lost");

    broker.replace(Map.of());
    remoteInbox.awaitTrouble("restored");
  }
}
