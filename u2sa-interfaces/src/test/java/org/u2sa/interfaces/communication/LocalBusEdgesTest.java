package org.u2sa.interfaces.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.schema.U2SAData;

/** What the local bus answers: to bridges that come late, closed connections, faulty receivers. */
class LocalBusEdgesTest {
  private final LocalBus bus = new LocalBus("cessna");
  private final List<U2SAData> received = new ArrayList<>();
  private final List<String> troubles = new ArrayList<>();
  private boolean faulty;

  private final Receiver receiver =
      new Receiver() {
        @Override
        public void receive(Channel<?> channel, U2SAData message) {
          if (faulty) {
            throw new IllegalStateException("faulty");
          }
          received.add(message);
        }

        @Override
        public void trouble(String what) {
          troubles.add(what);
        }
      };

  private static <T extends U2SAData> T frozen(T message) {
    message.freeze();
    return message;
  }

  @Test
  void attach_bridgeThatComesLate_isGivenWhatIsRetainedAndNothingElse() {
    Connection connection = bus.connect("a", receiver);
    GoalList goals = frozen(new GoalList());
    connection.publish(Channels.GOALS, frozen(new GoalList()));
    connection.publish(Channels.GOALS, goals);
    connection.publish(Channels.STATE, frozen(new StateInformation()));
    List<String> given = new ArrayList<>();

    bus.attach((channel, message) -> given.add(channel + " " + (message == goals)));

    assertThat(given).containsExactly("goals true");
  }

  @Test
  void subscribe_openAndClosed_saysWhetherItWasTaken() {
    Connection connection = bus.connect("a", receiver);
    assertThat(connection.subscribe(Channels.STATE)).isTrue();
    assertThat(connection.unsubscribe(Channels.STATE)).isTrue();

    connection.close();

    assertThat(connection.subscribe(Channels.STATE)).isFalse();
    assertThat(connection.unsubscribe(Channels.STATE)).isFalse();
    bus.deliver(Channels.STATE, frozen(new StateInformation()));
    assertThat(received).isEmpty();
  }

  @Test
  void close_twice_leavesTheNameToItsNextOwner() {
    Connection first = bus.connect("a", receiver);
    first.close();
    Connection next = bus.connect("a", receiver);
    next.subscribe(Channels.STATE);

    first.close();

    bus.deliver(Channels.STATE, frozen(new StateInformation()));
    assertThat(received).hasSize(1);
    assertThatThrownBy(() -> bus.connect("a", receiver)).isInstanceOf(CommunicationException.class);
  }

  @Test
  void instance_ofEachConnection_isItsOwn() {
    Connection first = bus.connect("a", receiver);
    Connection second = bus.connect("b", receiver);

    assertThat(first.instance()).isEqualTo(first.instance()).startsWith("local-");
    assertThat(first.instance()).isNotEqualTo(second.instance());
    assertThat(bus.systemId()).isEqualTo("cessna");
    assertThat(first.refusedSubscriptions()).isEmpty();
  }

  @Test
  void missed_onAChannel_isCountedByItsSubscribers() {
    Connection hears = bus.connect("a", receiver);
    Connection deaf = bus.connect("b", receiver);
    hears.subscribe(Channels.STATE);

    bus.missed(Channels.STATE, 3);
    bus.missed(Channels.STATE, 4);

    assertThat(hears.missed()).isEqualTo(7);
    assertThat(deaf.missed()).isZero();

    bus.missed(Channels.STATE, Long.MAX_VALUE);
    assertThat(hears.missed()).as("forged sequence numbers").isEqualTo(Long.MAX_VALUE);
  }

  @Test
  void receive_faultyReceiver_isToldAtPowersOfTwo() {
    faulty = true;
    Connection connection = bus.connect("a", receiver);
    connection.subscribe(Channels.STATE);
    for (int i = 0; i < 5; i++) {
      bus.deliver(Channels.STATE, frozen(new StateInformation()));
    }

    assertThat(connection.refused()).isEqualTo(5);
    assertThat(troubles)
        .hasSize(3)
        .last()
        .isEqualTo(
            "receiving on \"state\" failed: java.lang.IllegalStateException: faulty (4 so far)");
  }

  @Test
  void detach_oneOfTwo_leavesTheOther() {
    List<U2SAData> kept = new ArrayList<>();
    List<U2SAData> gone = new ArrayList<>();
    LocalBus.Bridge bridge = (channel, message) -> gone.add(message);
    bus.attach(bridge);
    bus.attach((channel, message) -> kept.add(message));
    bus.detach(bridge);

    bus.connect("a", receiver).publish(Channels.STATE, frozen(new StateInformation()));

    assertThat(gone).isEmpty();
    assertThat(kept).hasSize(1);
  }
}
