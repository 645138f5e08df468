package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.frozen;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import io.moquette.BrokerConstants;
import io.moquette.broker.Server;
import io.moquette.broker.config.IConfig;
import io.moquette.broker.config.MemoryConfig;
import java.io.IOException;
import java.util.Properties;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.testkit.FreePort;

/** What a service takes from a broker that lets everything through and retains everything. */
@Timeout(120)
class OutsideBrokerTest {
  private static final byte[] STOP = frozen(new StopCommand().stopAll(true)).serialize();
  private static final byte[] CLEAR =
      frozen(new EmergencyStop().active(false).clears(1L << 62)).serialize();

  private final int port = FreePort.find();
  private final Server server = new Server();
  private final RecordingReceiver inbox = new RecordingReceiver();

  @BeforeEach
  void start() throws IOException {
    Properties properties = new Properties();
    properties.setProperty(IConfig.HOST_PROPERTY_NAME, "127.0.0.1");
    properties.setProperty(IConfig.PORT_PROPERTY_NAME, String.valueOf(port));
    properties.setProperty(IConfig.SSL_PORT_PROPERTY_NAME, BrokerConstants.DISABLED_PORT_BIND);
    properties.setProperty(IConfig.ALLOW_ANONYMOUS_PROPERTY_NAME, "true");
    properties.setProperty(IConfig.PERSISTENCE_ENABLED_PROPERTY_NAME, "false");
    properties.setProperty(IConfig.ENABLE_TELEMETRY_NAME, "false");
    server.startServer(new MemoryConfig(properties));
  }

  @AfterEach
  void stop() {
    server.stopServer();
  }

  private Connection service() {
    Connection service = TestManager.transport(port).connect("Service", inbox);
    for (Channel<?> channel : Channels.all()) {
      assertThat(service.subscribe(channel)).isTrue();
    }
    return service;
  }

  @Test
  void connected_clientId_cannotBeToldFromWhatIsPublished() throws IOException {
    Connection service = service();
    assertThat(service.publish(Channels.GOALS, frozen(new GoalList()))).isTrue();
    soon().until(() -> !inbox.messages.isEmpty());

    String clientId = server.listConnectedClients().iterator().next().getClientID();
    String sender = inbox.messages.get(0).origin().orElseThrow().sender();
    assertThat(clientId).startsWith("cessna/Service/").doesNotContain(sender);
    assertThat(clientId).doesNotContain(service.instance());
    service.close();
  }

  private void awaitGoals(RawClient sender) throws IOException {
    GoalList last = frozen(new GoalList());
    sender.publish("u2sa/cessna/goals/GoalList", last.serialize(), 1);
    soon().until(() -> inbox.messages.stream().anyMatch(GoalList.class::isInstance));
  }

  @Test
  void arrived_typeThatTheChannelDoesNotCarry_isRefusedAndTold() throws IOException {
    Connection service = service();
    try (RawClient sender = new RawClient(port).introduced("sender")) {
      sender.publish("u2sa/cessna/configuration/ConfigurationRequest/EmergencyStop", CLEAR, 1);
      sender.publish("u2sa/cessna/discovery/DiscoveryRequest/StopCommand", STOP, 1);
      sender.publish("u2sa/cessna/discovery/StopCommand", STOP, 1);
      sender.publish("u2sa/cessna/functionality/EmergencyStop", CLEAR, 1);
      awaitGoals(sender);
    }
    assertThat(inbox.messages).allMatch(GoalList.class::isInstance);
    assertThat(service.refused()).isEqualTo(4);
    inbox.awaitTrouble("cannot be read");
    service.close();
  }

  @Test
  void arrived_commandThatSomebodyRetained_isRefusedAndTold() throws IOException {
    EmergencyStop set = frozen(new EmergencyStop().active(true));
    byte[] arm = frozen(new ArmCommand().arm(true).requestId("1").operator("x")).serialize();
    try (RetainingBroker outside =
        new RetainingBroker()
            .holding("u2sa/cessna/stop/StopCommand", STOP)
            .holding("u2sa/cessna/arming/ArmCommand", arm)
            .holding("u2sa/cessna/emergency-stop/EmergencyStop", set.serialize())) {
      Connection service = TestManager.transport(outside.start()).connect("Service", inbox);
      service.subscribe(Channels.STOP);
      service.subscribe(Channels.ARMING);
      service.subscribe(Channels.EMERGENCY_STOP);

      soon().until(() -> inbox.messages.contains(set)); // that one is there to be retained
      inbox.awaitTrouble("retains nothing");
      assertThat(inbox.messages).containsExactly(set);
      assertThat(service.refused()).isEqualTo(2);

      outside.publish("u2sa/cessna/stop/StopCommand", STOP, false); // now it is an order
      soon().until(() -> inbox.messages.size() > 1);
      assertThat(inbox.messages.get(1)).isInstanceOf(StopCommand.class);
      service.close();
    }
  }

  @Test
  void arrived_retainedOnAChannelKnownByNameOnly_isReceivedUnlessItIsACommand() throws Exception {
    StateInformation alarm = frozen(new StateInformation().sensorName("leak"));
    try (RetainingBroker outside =
        new RetainingBroker()
            .holding("u2sa/cessna/leak-alarms/StateInformation", alarm.serialize())
            .holding("u2sa/cessna/leak-orders/StopCommand", STOP)) {
      Connection service = TestManager.transport(outside.start()).connect("Service", inbox);
      service.subscribe(Channels.namedOrNew("leak-alarms"));
      service.subscribe(Channels.namedOrNew("leak-orders"));

      soon().until(() -> !inbox.messages.isEmpty());
      inbox.awaitTrouble("leak-orders");
      assertThat(inbox.messages).containsExactly(alarm);
      service.close();
    }
  }
}
