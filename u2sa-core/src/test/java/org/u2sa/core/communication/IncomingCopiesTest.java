package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.Origin;
import org.u2sa.messages.schema.U2SAData;

/** What remote clients publish, on its way to the services of this process. */
class IncomingCopiesTest {
  private static final MessageCodec CODEC = new MessageCodec(StandardTypes.registry());
  private static final String TOPIC = "u2sa/cessna/state/StateInformation";

  private final List<U2SAData> received = new ArrayList<>();
  private final List<String> log = new ArrayList<>();
  private final LocalBus bus = new LocalBus("cessna");
  private final IncomingCopies copies = new IncomingCopies(bus, CODEC, log::add);
  private final Connection connection = bus.connect("reader", receiver());

  IncomingCopiesTest() {
    connection.subscribe(Channels.STATE);
  }

  private Receiver receiver() {
    return new Receiver() {
      @Override
      public void receive(Channel<?> channel, U2SAData message) {
        received.add(message);
      }

      @Override
      public void trouble(String what) {
        throw new AssertionError(what);
      }
    };
  }

  private static byte[] state(long sequence) {
    StateInformation state = new StateInformation();
    state.freeze();
    return CODEC.encode(state, new Origin("remote", sequence));
  }

  @Test
  void deliver_ofThisSystem_reachesItsSubscribersFrozen() {
    copies.deliver(TOPIC, state(1));

    assertThat(received).singleElement().matches(U2SAData::isFrozen);
    assertThat(log).isEmpty();
  }

  @Test
  void deliver_ofAnotherSystem_reachesNobodyInSilence() {
    copies.deliver(TOPIC.replace("cessna", "boat"), state(1));

    assertThat(received).isEmpty();
    assertThat(log).isEmpty();
  }

  @Test
  void deliver_gapInTheNumbers_isMissedByTheSubscribers() {
    copies.deliver(TOPIC, state(1));
    assertThat(connection.missed()).isZero();
    copies.deliver(TOPIC, state(4));

    assertThat(connection.missed()).isEqualTo(2);
  }

  @Test
  void deliver_unreadable_isToldAtPowersOfTwo() {
    for (int i = 0; i < 4; i++) {
      copies.deliver(TOPIC, new byte[] {(byte) 0xff});
    }

    assertThat(received).isEmpty();
    assertThat(log).hasSize(3);
    assertThat(log.get(2))
        .startsWith("a message on \"" + TOPIC + "\" cannot be read: ")
        .endsWith(" (4 so far)");
  }

  @Test
  void deliver_typeOfAnotherChannel_reachesNobodyAndIsTold() {
    GoalList goals = new GoalList();
    goals.freeze();
    copies.deliver("u2sa/cessna/state/GoalList", goals.serialize());

    assertThat(received).isEmpty();
    assertThat(log)
        .singleElement()
        .asString()
        .contains("its type does not match the channel: StateInformation");
  }
}
