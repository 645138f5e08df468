package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.command;
import static org.u2sa.core.communication.BrokerTraffic.frozen;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.schema.U2SAData;

/**
 * What every way to the Communication Manager does alike, so that a service cannot tell which it
 * uses.
 */
@Timeout(90)
abstract class TransportContract {
  private final RecordingReceiver inbox = new RecordingReceiver();
  private Connection publisher;
  private Connection subscriber;

  /** The transport under test, for system "cessna". */
  abstract Transport transport();

  /** Ends what {@link #transport} needed. */
  abstract void close();

  @BeforeEach
  void connect() {
    Transport transport = transport();
    publisher = transport.connect("Publisher", new RecordingReceiver());
    subscriber = transport.connect("Subscriber", inbox);
  }

  @AfterEach
  void disconnect() {
    subscriber.close();
    publisher.close();
    close();
  }

  @Test
  void publish_subclass_arrivesWholeAndFrozen() {
    subscriber.subscribe(Channels.ACTUATION);
    PercentageCommand command = command(5.0);

    assertThat(publisher.publish(Channels.ACTUATION, command)).isTrue();

    soon().until(() -> inbox.messages.size() == 1);
    assertThat(inbox.messages.get(0)).isEqualTo(command).isInstanceOf(PercentageCommand.class);
    assertThat(inbox.messages.get(0).isFrozen()).isTrue();
  }

  @Test
  void publish_many_arriveInOrderAndNoneTwice() {
    subscriber.subscribe(Channels.GOAL_COMMANDS);
    subscriber.subscribe(Channels.ACTUATION);
    List<U2SAData> sent = new CopyOnWriteArrayList<>();
    for (int i = 0; i < 200; i++) {
      PercentageCommand command = command(i / 2.0);
      sent.add(command);
      publisher.publish(Channels.ACTUATION, command);
    }

    soon().until(() -> inbox.messages.size() >= sent.size());
    assertThat(inbox.messages).containsExactlyElementsOf(sent);
  }

  @Test
  void publish_onAnotherChannel_doesNotArrive() {
    subscriber.subscribe(Channels.ACTUATION);
    ActuatorCommand command = command(5.0);

    publisher.publish(Channels.STATE, frozen(new StateInformation().sensorName("a").x(1.0)));
    publisher.publish(Channels.ACTUATION, command);

    soon().until(() -> inbox.messages.contains(command));
    assertThat(inbox.messages).containsExactly(command);
  }

  @Test
  void publish_notOfTheChannelsType_isRefusedAndCounted() {
    assertThat(publisher.publish(Channels.STATE, command(5.0))).isFalse();
    assertThat(publisher.refused()).isEqualTo(1);
  }

  @Test
  void unsubscribe_thenPublish_nothingArrives() {
    subscriber.subscribe(Channels.ACTUATION);
    subscriber.subscribe(Channels.STATE);
    subscriber.unsubscribe(Channels.ACTUATION);
    StateInformation last = frozen(new StateInformation().sensorName("a").x(1.0));

    publisher.publish(Channels.ACTUATION, command(5.0));
    publisher.publish(Channels.STATE, last);

    soon().until(() -> inbox.messages.contains(last));
    assertThat(inbox.messages).containsExactly(last);
  }

  @Test
  void subscribe_late_getsWhatIsRetained() {
    GoalList goals = frozen(new GoalList());
    publisher.publish(Channels.GOALS, goals);

    soon()
        .until(
            () -> {
              subscriber.subscribe(Channels.GOALS);
              return inbox.messages.contains(goals);
            });
  }

  @Test
  void subscribe_late_getsTheLastOfEachSource() {
    ActuatorAnnouncement elevator = announcement("ELEVATOR");
    ActuatorAnnouncement rudder = announcement("RUDDER / left + right");
    publisher.publish(Channels.ACTUATORS, elevator);
    publisher.publish(Channels.ACTUATORS, rudder);

    soon()
        .until(
            () -> {
              subscriber.subscribe(Channels.ACTUATORS);
              return inbox.messages.containsAll(List.of(elevator, rudder));
            });
  }

  private static ActuatorAnnouncement announcement(String name) {
    return frozen(
        new ActuatorAnnouncement()
            .actuatorName(name)
            .minimum(0.0)
            .maximum(100.0)
            .effect("turns")
            .subsystem("all"));
  }

  @Test
  void close_rightAfterPublishing_messagesStillArrive() {
    subscriber.subscribe(Channels.ACTUATION);
    List<U2SAData> sent = new CopyOnWriteArrayList<>();
    for (int i = 0; i < 500; i++) {
      PercentageCommand command = command(i / 5.0);
      sent.add(command);
      publisher.publish(Channels.ACTUATION, command);
    }
    publisher.close();

    soon().until(() -> inbox.messages.size() >= sent.size());
    assertThat(inbox.messages).containsExactlyElementsOf(sent);
    assertThat(publisher.refused()).isZero();
  }

  @Test
  void close_thenPublish_isRefused() {
    publisher.close();
    publisher.close();

    assertThat(publisher.publish(Channels.ACTUATION, command(5.0))).isFalse();
  }

  @Test
  void instance_isAnotherForEachConnectionAndStaysWhenItIsClosed() {
    String first = publisher.instance();
    publisher.close();

    Connection successor = transport().connect("Publisher", new RecordingReceiver());

    assertThat(successor.instance()).isNotBlank().isNotEqualTo(first);
    assertThat(successor.instance()).isNotEqualTo(subscriber.instance());
    assertThat(publisher.instance()).isEqualTo(first);
    successor.close();
  }

  @Test
  void systemId_isTheOneAskedFor() {
    assertThat(transport().systemId()).isEqualTo("cessna");
  }
}
