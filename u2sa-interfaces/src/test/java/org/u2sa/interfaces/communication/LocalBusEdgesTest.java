package org.u2sa.interfaces.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
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

  private static PlannedPath plan(String subsystem, int points) {
    return new PlannedPath()
        .subsystem(subsystem)
        .planner("PathPlanner")
        .status(PathStatus.FOLLOWED)
        .points(Collections.nCopies(points, Point.of(1.0, 2.0, 3.0)));
  }

  private static PlannedPath received(PlannedPath sent) throws MalformedMessageException {
    return (PlannedPath) decoded(sent);
  }

  private static U2SAData decoded(U2SAData sent) throws MalformedMessageException {
    return frozen(
        new MessageCodec(StandardTypes.registry()).decode(sent.typeChain(), sent.serialize()));
  }

  private List<String> retainedPlans() {
    received.clear();
    try (Connection late = bus.connect("late", receiver)) {
      late.subscribe(Channels.PLANS);
    }
    return received.stream().map(message -> ((PlannedPath) message).subsystem()).toList();
  }

  @Test
  void subscribe_afterLongMessagesOfInventedSources_bringsSomeMegabytesOnly()
      throws MalformedMessageException {
    long most = Math.max(2L << 20, Runtime.getRuntime().maxMemory() / 64);
    PlannedPath first = received(plan("s0", 30_000));
    int sent = (int) (2 * most / first.receivedBytes()) + 2;
    for (int i = 0; i < sent; i++) {
      bus.deliver(Channels.PLANS, received(plan("s" + i, 30_000)));
    }
    bus.connect("PathPlanner", receiver).publish(Channels.PLANS, frozen(plan("own", 30_000)));

    List<String> plans = retainedPlans();
    assertThat(plans).hasSizeBetween(2, sent).startsWith("s0").endsWith("own");
    assertThat((plans.size() - 1L) * first.receivedBytes()).isLessThanOrEqualTo(most);
  }

  @Test
  void deliver_messageThatHasNoRoom_leavesNoOlderOneInItsPlace() throws MalformedMessageException {
    long most = Math.max(2L << 20, Runtime.getRuntime().maxMemory() / 64);
    bus.deliver(Channels.PLANS, received(plan("real", 1)));
    int all = (int) (most / received(plan("s0", 30_000)).receivedBytes());
    for (int i = 0; i < all; i++) {
      bus.deliver(Channels.PLANS, received(plan("s" + i, 30_000)));
    }
    assertThat(retainedPlans()).contains("real", "s" + (all - 1));

    bus.deliver(Channels.PLANS, received(plan("real", 30_000)));

    assertThat(retainedPlans()).hasSize(all).doesNotContain("real");
  }

  @Test
  void deliver_messageOfAnOnlyWriterBeyondTheBudget_isRetainedAndAnInventedSourcesNot()
      throws MalformedMessageException {
    LocalBus small = new LocalBus("cessna", 1);
    GoalList sent = (GoalList) decoded(new GoalList());
    small.deliver(Channels.GOALS, sent);
    small.deliver(Channels.PLANS, received(plan("invented", 1)));

    Connection late = small.connect("late", receiver);
    late.subscribe(Channels.GOALS);
    late.subscribe(Channels.PLANS);

    assertThat(sent.receivedBytes()).isGreaterThan(1);
    assertThat(received).containsExactly(sent);
  }

  @Test
  void isLocal_untilItsConnectionIsClosed() {
    StateInformation state = frozen(new StateInformation().sensorName("gps"));
    Connection gps = bus.connect("Gps", receiver);
    assertThat(bus.isLocal("sensed-state", "gps")).isFalse();

    gps.publish(Channels.SENSED_STATE, state);
    bus.deliver(Channels.SENSED_STATE, frozen(new StateInformation().sensorName("imu")));

    assertThat(bus.isLocal("sensed-state", "gps")).isTrue();
    assertThat(bus.isLocal("state", "gps")).isFalse();
    assertThat(bus.isLocal("sensed-state", "imu")).as("of another process").isFalse();
    gps.close();
    assertThat(bus.isLocal("sensed-state", "gps")).isFalse();
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
}
