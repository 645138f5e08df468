package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.frozen;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.io.IOException;
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

/** What a service takes from a broker that lets everything through and retains everything. */
@Timeout(120)
class OutsideBrokerTest {
  private static final byte[] STOP = frozen(new StopCommand().stopAll(true)).serialize();
  private static final byte[] CLEAR =
      frozen(new EmergencyStop().active(false).clears(1L << 62)).serialize();

  private final RecordingReceiver inbox = new RecordingReceiver();

  private Connection service(RetainingBroker outside) {
    Connection service = TestManager.transport(outside.start()).connect("Service", inbox);
    for (Channel<?> channel : Channels.all()) {
      assertThat(service.subscribe(channel)).isTrue();
    }
    return service;
  }

  @Test
  void connected_clientId_cannotBeToldFromWhatIsPublished() throws IOException {
    try (RetainingBroker outside = new RetainingBroker()) {
      Connection service = service(outside);
      assertThat(service.publish(Channels.GOALS, frozen(new GoalList()))).isTrue();
      soon().until(() -> !inbox.messages.isEmpty());

      String sender = inbox.messages.get(0).origin().orElseThrow().sender();
      assertThat(outside.clientId()).startsWith("cessna/Service/").doesNotContain(sender);
      assertThat(outside.clientId()).doesNotContain(service.instance());
      service.close();
    }
  }

  @Test
  void arrived_typeThatTheChannelDoesNotCarry_isRefusedAndTold() throws IOException {
    try (RetainingBroker outside = new RetainingBroker()) {
      Connection service = service(outside);
      outside.publish("u2sa/cessna/configuration/ConfigurationRequest/EmergencyStop", CLEAR, false);
      outside.publish("u2sa/cessna/discovery/DiscoveryRequest/StopCommand", STOP, false);
      outside.publish("u2sa/cessna/discovery/StopCommand", STOP, false);
      outside.publish("u2sa/cessna/functionality/EmergencyStop", CLEAR, false);
      GoalList last = frozen(new GoalList());
      outside.publish("u2sa/cessna/goals/GoalList", last.serialize(), false);

      inbox.awaitMessage(last);
      assertThat(inbox.messages).containsExactly(last);
      assertThat(service.refused()).isEqualTo(4);
      inbox.awaitTrouble("cannot be read");
      service.close();
    }
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
