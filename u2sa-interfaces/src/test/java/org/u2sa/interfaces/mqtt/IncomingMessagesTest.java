package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.Origin;
import org.u2sa.messages.schema.U2SAData;

/** What becomes of the messages that come in over MQTT, and what is said of those that do not. */
class IncomingMessagesTest {
  private static final Topic TOPIC = Topic.of("cessna", Channels.STATE, StateInformation.TYPE);

  private final List<U2SAData> received = new ArrayList<>();
  private final List<String> troubles = new ArrayList<>();
  private RuntimeException fault;
  private final MessageCodec codec = new MessageCodec(StandardTypes.registry());
  private final IncomingMessages incoming =
      new IncomingMessages(
          codec,
          new Receiver() {
            @Override
            public void receive(Channel<?> channel, U2SAData message) {
              if (fault != null) {
                throw fault;
              }
              received.add(message);
            }

            @Override
            public void trouble(String what) {
              troubles.add(what);
            }
          });

  private void arrives(long sequence) {
    StateInformation state = new StateInformation();
    state.freeze();
    incoming.hand(Channels.STATE, TOPIC, codec.encode(state, new Origin("a", sequence)));
  }

  @Test
  void hand_message_isReceivedFrozenAndNothingIsRefused() {
    arrives(1);

    assertThat(received).singleElement().matches(U2SAData::isFrozen);
    assertThat(incoming.refused()).isZero();
    assertThat(incoming.missed()).isZero();
    assertThat(troubles).isEmpty();
  }

  @Test
  void hand_noCbor_isRefusedAndTold() {
    incoming.hand(Channels.STATE, TOPIC, new byte[] {(byte) 0xff});

    assertThat(received).isEmpty();
    assertThat(incoming.refused()).isOne();
    assertThat(troubles)
        .singleElement()
        .asString()
        .startsWith("a message on " + TOPIC + " cannot be read: ")
        .endsWith("(1 so far)");
  }

  @Test
  void hand_typeThatTheChannelDoesNotCarry_isRefusedAndNamesTheChannelsType() {
    GoalList goals = new GoalList();
    goals.freeze();
    Topic topic = new Topic("cessna", "state", GoalList.TYPE.chain());

    incoming.hand(Channels.STATE, topic, goals.serialize());

    assertThat(received).isEmpty();
    assertThat(troubles)
        .containsExactly("a message on " + topic + " is not of type StateInformation (1 so far)");
  }

  @Test
  void hand_receiverThrows_isCountedAndTold() {
    fault = new IllegalStateException("faulty");

    arrives(1);

    assertThat(incoming.refused()).isOne();
    assertThat(troubles)
        .containsExactly(
            "receiving a message on "
                + TOPIC
                + " failed: java.lang.IllegalStateException: faulty (1 so far)");
  }

  @Test
  void hand_gaps_areToldWhenTheirSumPassesAPowerOfTwo() {
    arrives(1);
    arrives(3); // 1 missed
    arrives(5); // 2
    arrives(7); // 3
    arrives(9); // 4
    arrives(10);
    arrives(15); // 8

    assertThat(incoming.missed()).isEqualTo(8);
    assertThat(troubles)
        .containsExactly(
            "1 messages on " + TOPIC + " were missed (1 so far)",
            "1 messages on " + TOPIC + " were missed (2 so far)",
            "1 messages on " + TOPIC + " were missed (4 so far)",
            "4 messages on " + TOPIC + " were missed (8 so far)");
    assertThat(incoming.refused()).isZero();
  }

  private void arrives(Channel<?> channel, U2SAData message, long sequence) {
    U2SAData copy = message.copy();
    copy.freeze();
    Topic topic = Topic.of("cessna", channel, message.type());
    incoming.hand(channel, topic, codec.encode(copy, new Origin("a", sequence)));
  }

  /** After a reconnection, outside brokers deliver QoS 1 messages again. */
  @Test
  void hand_oldStateAfterANewOne_isIgnored() {
    arrives(Channels.ARMING_STATE, new ArmingState().armed(true), 22);
    arrives(Channels.ARMING_STATE, new ArmingState().armed(false), 23);
    arrives(Channels.ARMING_STATE, new ArmingState().armed(true), 22);
    arrives(Channels.FAILSAFE, new FailsafeState().action(FailsafeAction.HOLD), 7);
    arrives(Channels.FAILSAFE, new FailsafeState().action(FailsafeAction.CONTINUE), 6);

    assertThat(received).hasSize(3);
    assertThat(received.get(1)).isEqualTo(new ArmingState().armed(false));
    incoming.forget(Channels.ARMING_STATE); // subscribed again: the retained one counts
    arrives(Channels.ARMING_STATE, new ArmingState().armed(false), 23);
    assertThat(received).hasSize(4);
  }

  /** Whoever may stop a vehicle must not be able to silence another by its sequence numbers. */
  @Test
  void hand_stopAndEventWithAnOldNumber_areReceived() {
    arrives(Channels.EMERGENCY_STOP, new EmergencyStop().active(false), Long.MAX_VALUE);
    arrives(Channels.EMERGENCY_STOP, new EmergencyStop().active(true).stopId("b 1"), 3);
    arrives(Channels.ARMING, new ArmCommand().requestId("1").arm(true), 9);
    arrives(Channels.ARMING, new ArmCommand().requestId("2").arm(false), 8);

    assertThat(received).hasSize(4);
  }

  @Test
  void forget_channel_nextNumberThereIsHeardAsTheFirst() {
    arrives(1);
    incoming.forget(Channels.HEALTH);
    arrives(3);
    assertThat(incoming.missed()).isOne();

    incoming.forget(Channels.STATE);
    arrives(100);

    assertThat(incoming.missed()).isOne();
  }

  @Test
  void refuse_again_isToldAtPowersOfTwoOnly() {
    for (int i = 0; i < 9; i++) {
      incoming.refuse("no");
    }

    assertThat(troubles)
        .containsExactly("no (1 so far)", "no (2 so far)", "no (4 so far)", "no (8 so far)");
  }

  @Test
  void refuseMany_toldElsewhere_isCountedInSilence() {
    incoming.refuse(7);

    assertThat(incoming.refused()).isEqualTo(7);
    assertThat(troubles).isEmpty();
  }
}
