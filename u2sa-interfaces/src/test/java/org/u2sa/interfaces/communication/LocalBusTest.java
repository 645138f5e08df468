package org.u2sa.interfaces.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

class LocalBusTest {
  private final LocalBus bus = new LocalBus("cessna");
  private final Inbox inbox = new Inbox();

  private static class Inbox implements Receiver {
    private final List<U2SAData> messages = new ArrayList<>();

    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      messages.add(message);
    }

    @Override
    public void trouble(String what) {
      throw new AssertionError(what);
    }
  }

  private static <T extends U2SAData> T frozen(T message) {
    message.freeze();
    return message;
  }

  @Test
  void publish_subclass_reachesSubscribersOfTheChannelAsTheSameObject() {
    bus.connect("a", inbox).subscribe(Channels.ACTUATION);
    PercentageCommand command = frozen(PercentageCommand.of("RUDDER", 5.0));

    boolean taken = bus.connect("b", new Inbox()).publish(Channels.ACTUATION, command);

    assertThat(taken).isTrue();
    assertThat(inbox.messages).singleElement().isSameAs(command);
  }

  @Test
  void publish_otherType_isRefusedAndCounted() {
    Connection connection = bus.connect("a", inbox);
    connection.subscribe(Channels.STATE);

    assertThat(connection.publish(Channels.STATE, frozen(PercentageCommand.of("RUDDER", 5.0))))
        .isFalse();
    assertThat(connection.refused()).isEqualTo(1);
    assertThat(inbox.messages).isEmpty();
  }

  @Test
  void subscribe_late_getsRetainedMessageOnlyOnRetainedChannels() {
    Connection publisher = bus.connect("a", new Inbox());
    GoalList goals = frozen(new GoalList());
    publisher.publish(Channels.GOALS, goals);
    publisher.publish(Channels.STATE, frozen(new StateInformation()));

    Connection late = bus.connect("b", inbox);
    late.subscribe(Channels.GOALS);
    late.subscribe(Channels.STATE);

    assertThat(inbox.messages).singleElement().isSameAs(goals);
  }

  @Test
  void unsubscribe_thenPublish_nothingArrives() {
    Connection connection = bus.connect("a", inbox);
    connection.subscribe(Channels.STATE);
    connection.unsubscribe(Channels.STATE);

    connection.publish(Channels.STATE, frozen(new StateInformation()));

    assertThat(inbox.messages).isEmpty();
  }

  @Test
  void subscribe_twice_messagesArriveOnce() {
    Connection connection = bus.connect("a", inbox);
    connection.subscribe(Channels.STATE);
    connection.subscribe(Channels.STATE);

    connection.publish(Channels.STATE, frozen(new StateInformation()));

    assertThat(inbox.messages).hasSize(1);
  }

  @Test
  void connect_takenName_isRefusedUntilItsOwnerCloses() {
    Connection first = bus.connect("a", inbox);

    assertThatThrownBy(() -> bus.connect("a", inbox))
        .isInstanceOf(CommunicationException.class)
        .hasMessageContaining("\"a\"")
        .hasMessageContaining("cessna");
    first.close();
    assertThat(bus.connect("a", inbox)).isNotNull();
  }

  @Test
  void close_endsSubscriptionsAndPublishing() {
    Connection connection = bus.connect("a", inbox);
    connection.subscribe(Channels.STATE);
    connection.close();

    assertThat(connection.publish(Channels.STATE, frozen(new StateInformation()))).isFalse();
    bus.deliver(Channels.STATE, frozen(new StateInformation()));
    assertThat(inbox.messages).isEmpty();
  }

  @Test
  void attach_bridge_seesLocalMessagesButNotDeliveredOnes() {
    List<U2SAData> bridged = new ArrayList<>();
    bus.attach((channel, message) -> bridged.add(message));
    StateInformation local = frozen(new StateInformation());

    bus.connect("a", inbox).publish(Channels.STATE, local);
    bus.deliver(Channels.STATE, frozen(new StateInformation()));

    assertThat(bridged).singleElement().isSameAs(local);
  }

  @Test
  void attach_severalBridges_eachSeesAllUntilItIsTakenOff() {
    List<U2SAData> broker = new ArrayList<>();
    List<U2SAData> recorder = new ArrayList<>();
    LocalBus.Bridge recording = (channel, message) -> recorder.add(message);
    bus.attach((channel, message) -> broker.add(message));
    bus.attach(recording);
    Connection connection = bus.connect("a", inbox);

    connection.publish(Channels.STATE, frozen(new StateInformation()));
    bus.detach(recording);
    connection.publish(Channels.STATE, frozen(new StateInformation()));

    assertThat(broker).hasSize(2);
    assertThat(recorder).hasSize(1);
  }

  @Test
  void publish_oneBridgeThrows_publisherAndOtherBridgesDoNotNotice() {
    List<U2SAData> other = new ArrayList<>();
    bus.attach(
        (channel, message) -> {
          throw new IllegalStateException("full");
        });
    bus.attach((channel, message) -> other.add(message));
    List<String> troubles = new ArrayList<>();
    Connection connection =
        bus.connect(
            "a",
            new Inbox() {
              @Override
              public void trouble(String what) {
                troubles.add(what);
              }
            });

    assertThat(connection.publish(Channels.STATE, frozen(new StateInformation()))).isTrue();

    assertThat(other).hasSize(1);
    assertThat(connection.refused()).isEqualTo(1);
    assertThat(troubles).singleElement().asString().contains("forwarding on \"state\"", "full");
  }

  @Test
  void publishRetained_twoPublishersAtOnce_sameOneIsLastOnTheBusAndBeyondTheBridge()
      throws InterruptedException {
    AtomicReference<U2SAData> beyond = new AtomicReference<>();
    Connection first = bus.connect("first", new Inbox());
    Connection second = bus.connect("second", new Inbox());
    GoalList one = frozen(new GoalList());
    GoalList two = frozen(new GoalList());
    Thread other = new Thread(() -> second.publish(Channels.GOALS, two));
    Receiver meanwhile = // while the first is being handed out, the second is published
        new Inbox() {
          @Override
          public void receive(Channel<?> channel, U2SAData message) {
            if (message == one) {
              other.start();
            }
          }
        };
    bus.connect("reader", meanwhile).subscribe(Channels.GOALS);
    bus.attach(
        (channel, message) -> {
          if (message == one) {
            awaitBlockedOrEnded(other);
          }
          beyond.set(message);
        });

    first.publish(Channels.GOALS, one);
    other.join();

    Inbox late = new Inbox();
    bus.connect("late", late).subscribe(Channels.GOALS);
    assertThat(late.messages).singleElement().isSameAs(two);
    assertThat(beyond).hasValue(two);
  }

  @Test
  void deliverRetained_localServicePublishesItToo_isRestatedBeyondTheBridgeSoThatBothEndAlike() {
    List<U2SAData> beyond = new ArrayList<>();
    bus.attach(
        new LocalBus.Bridge() {
          @Override
          public void forward(Channel<?> channel, U2SAData message) {
            beyond.add(message);
          }

          @Override
          public void restate(Channel<?> channel, U2SAData message) {
            beyond.add(message);
          }
        });
    List<U2SAData> tapped = new ArrayList<>();
    bus.attach((channel, message) -> tapped.add(message));
    GoalList before = frozen(new GoalList());
    GoalList local = frozen(new GoalList());
    GoalList remote = frozen(new GoalList());

    bus.deliver(Channels.GOALS, before); // nobody here publishes yet: the broker has it
    bus.connect("a", inbox).publish(Channels.GOALS, local); // perhaps after the next, beyond
    bus.deliver(Channels.GOALS, remote);

    assertThat(beyond).hasSize(2);
    assertThat(beyond.get(0)).isSameAs(local);
    assertThat(beyond.get(1)).isSameAs(remote);
    assertThat(tapped).singleElement().isSameAs(local);
  }

  private static void awaitBlockedOrEnded(Thread thread) {
    while (thread.getState() != Thread.State.BLOCKED
        && thread.getState() != Thread.State.TERMINATED) {
      Thread.onSpinWait();
    }
  }

  /** Breaks its promise not to throw. */
  private static final class Faulty implements Receiver {
    private final List<String> troubles = new ArrayList<>();

    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      throw new IllegalStateException("faulty");
    }

    @Override
    public void trouble(String what) {
      troubles.add(what);
      throw new IllegalStateException("faulty here too");
    }
  }

  @Test
  void publish_oneReceiverThrows_neitherPublisherNorTheOthersNotice() {
    Faulty faulty = new Faulty();
    Connection ofFaulty = bus.connect("faulty", faulty);
    ofFaulty.subscribe(Channels.STATE);
    bus.connect("b", inbox).subscribe(Channels.STATE);

    boolean taken =
        bus.connect("c", new Inbox()).publish(Channels.STATE, frozen(new StateInformation()));

    assertThat(taken).isTrue();
    assertThat(inbox.messages).hasSize(1);
    assertThat(ofFaulty.refused()).isEqualTo(1);
    assertThat(faulty.troubles).singleElement().asString().contains("faulty").contains("state");
  }

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
