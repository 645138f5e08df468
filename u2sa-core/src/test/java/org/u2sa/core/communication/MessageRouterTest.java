package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.frozen;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.safety.StopCommand;

/** Messages that go past Moquette, beside those that do not. */
@Timeout(60)
class MessageRouterTest {
  private static final String STOP = "u2sa/cessna/stop/StopCommand";

  private final AttackedBroker broker = new AttackedBroker(Map.of());

  @AfterEach
  void stop() throws IOException {
    broker.close();
  }

  @Test
  void publish_eachMatters_isAcknowledgedAndReachesRemoteAndLocalSubscribers() throws IOException {
    RecordingReceiver local = new RecordingReceiver();
    Connection sink = broker.manager.transport().connect("Sink", local);
    sink.subscribe(Channels.STOP);
    RawClient listener = broker.stranger().introduced("listener");
    assertThat(listener.subscribe("u2sa/cessna/stop/#", 1)).isEqualTo(1);
    RawClient publisher = broker.stranger().introduced("publisher");
    StopCommand command = frozen(new StopCommand().serviceName("Other"));

    publisher.publish(STOP, command.serialize(), 1);

    assertThat(publisher.next()).isEqualTo(0x40); // PUBACK
    assertThat(listener.nextMessage()).isPositive();
    AttackedBroker.soon().until(() -> local.messages.contains(command));
    sink.close();
  }

  @Test
  void publish_nothingIsRetained_wakesNoThreadOfMoquettes() throws IOException {
    RawClient listener = broker.stranger().introduced("listener");
    assertThat(listener.subscribe("u2sa/cessna/stop/#", 0)).isZero();
    RawClient publisher = broker.stranger().introduced("publisher");
    byte[] command = frozen(new StopCommand().serviceName("Other")).serialize();
    int messages = 200;
    long before = waitsOfMoquette();

    for (int i = 0; i < messages; i++) {
      publisher.publish(STOP, command, 1);
      assertThat(publisher.next()).isEqualTo(0x40);
      assertThat(listener.next()).isEqualTo(0x30);
    }

    assertThat(waitsOfMoquette() - before).isLessThan(messages / 2);
  }

  /** How often its threads of sessions have begun to wait, so far. */
  private static long waitsOfMoquette() {
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    return Arrays.stream(threads.getThreadInfo(threads.getAllThreadIds()))
        .filter(thread -> thread != null && thread.getThreadName().startsWith("Session Executor"))
        .mapToLong(ThreadInfo::getWaitedCount)
        .sum();
  }

  @Test
  void publish_subscriberOfQualityZero_getsItWithQualityZero() throws IOException {
    RawClient listener = broker.stranger().introduced("listener");
    assertThat(listener.subscribe("u2sa/cessna/#", 0)).isZero();

    broker.bus.publish(Channels.STOP, frozen(new StopCommand().serviceName("Other")));

    assertThat(listener.next()).isEqualTo(0x30);
  }

  @Test
  void publish_retainedAndNotInTurn_noTwoUnacknowledgedPacketsHaveOneNumber() throws IOException {
    RawClient listener = broker.stranger().introduced("listener");
    assertThat(listener.subscribe("u2sa/cessna/#", 1)).isEqualTo(1);
    int each = 5; // Moquette sends no more than ten that are not acknowledged
    for (int i = 0; i < each; i++) {
      broker.bus.publish(Channels.GOALS, frozen(new GoalList())); // by Moquette, which keeps it
      broker.bus.publish(Channels.STOP, frozen(new StopCommand().serviceName("Other " + i)));
    }

    Set<Integer> numbers = new TreeSet<>();
    for (int i = 0; i < 2 * each; i++) {
      numbers.add(listener.nextMessage());
    }
    assertThat(numbers).hasSize(2 * each);
  }

  @Test
  void publish_twoThousandOfALocalService_noneIsLost() throws IOException {
    RecordingReceiver inbox = new RecordingReceiver();
    Connection remote = broker.remote(inbox);
    remote.subscribe(Channels.STOP);
    int messages = 2_000;

    for (int i = 0; i < messages; i++) {
      broker.bus.publish(Channels.STOP, frozen(new StopCommand().serviceName("Other " + i)));
    }

    AttackedBroker.soon().until(() -> inbox.messages.size() >= messages);
    assertThat(inbox.messages).hasSize(messages);
    assertThat(broker.manager.dropped()).isZero();
    remote.close();
  }

  @Test
  void publish_afterTheLastLocalSubscriberLeft_whatComesMeanwhileIsNotMissed() throws IOException {
    RecordingReceiver local = new RecordingReceiver();
    Connection sink = broker.manager.transport().connect("Sink", local);
    Connection remote = broker.remote(new RecordingReceiver());
    StateInformation first = frozen(new StateInformation().sensorName("a").x(1.0));
    StateInformation unheard = frozen(new StateInformation().sensorName("a").x(2.0));
    StateInformation last = frozen(new StateInformation().sensorName("a").x(3.0));
    sink.subscribe(Channels.STATE);
    remote.publish(Channels.STATE, first);
    AttackedBroker.soon().until(() -> local.messages.contains(first));

    sink.unsubscribe(Channels.STATE);
    remote.publish(Channels.STATE, unheard);
    broker.servesOn(); // so it has passed
    sink.subscribe(Channels.STATE);
    remote.publish(Channels.STATE, last);

    AttackedBroker.soon().until(() -> local.messages.contains(last));
    assertThat(local.messages).containsExactly(first, last);
    assertThat(sink.missed()).isZero();
    sink.close();
    remote.close();
  }
}
