package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/** What a connection takes from a broker that lets everything through. */
class MqttConnectionTest {
  private static final String ACTUATORS = "u2sa/cessna/actuators/ActuatorAnnouncement/=";

  private final List<String> troubles = new ArrayList<>();
  private final MqttConnection connection =
      new MqttConnection(
          "tcp://127.0.0.1:1",
          "cessna",
          "Control",
          new MessageCodec(StandardTypes.registry()),
          new Receiver() {
            @Override
            public void receive(Channel<?> channel, U2SAData message) {
              throw new AssertionError("nothing is subscribed to");
            }

            @Override
            public void trouble(String what) {
              troubles.add(what);
            }
          },
          MqttClient.DIRECT,
          true);

  private void arrives(int topicLength) {
    connection.arrived(
        ACTUATORS + "x".repeat(topicLength - ACTUATORS.length()), new byte[] {1}, true);
  }

  /** The embedded broker refuses such topics; others keep them, and so would this connection. */
  @Test
  void arrived_topicLongerThanTheEmbeddedBrokerTakes_isRefused() {
    arrives(1_024);
    assertThat(troubles).isEmpty();

    arrives(1_025);
    assertThat(troubles).containsExactly("a message on a topic of 1025 characters (1 so far)");
  }

  @Test
  void topicNames_ofEachMessage_areThoseOfTheTopic() {
    MqttConnection.TopicNames names = new MqttConnection.TopicNames("cessna");
    StateInformation state = new StateInformation();

    assertThat(names.of(Channels.STATE, state)).isEqualTo("u2sa/cessna/state/StateInformation");
    assertThat(names.of(Channels.STATE, state)).isSameAs(names.of(Channels.STATE, state));
    assertThat(names.of(Channels.GOALS, new GoalList())).isEqualTo("u2sa/cessna/goals/GoalList");
    assertThat(names.of(Channels.SENSED_STATE, state))
        .isEqualTo("u2sa/cessna/sensed-state/StateInformation");
  }
}
