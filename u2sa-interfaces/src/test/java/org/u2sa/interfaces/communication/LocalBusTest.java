package org.u2sa.interfaces.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.goal.GoalList;
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
}
