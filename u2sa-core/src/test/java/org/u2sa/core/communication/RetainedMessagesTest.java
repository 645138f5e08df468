package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.frozen;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Supplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.schema.U2SAData;

/** What is retained comes with the flag to who asks later, and without it to who was there. */
@Timeout(60)
class RetainedMessagesTest {
  private static final String GOALS = "u2sa/cessna/goals/#";
  private static final String ANNOUNCED = "u2sa/cessna/actuators/#";
  private static final int PUBACK = 0x40;
  private static final int SUBACK = 0x90;
  private static final int LIVE = 0x32; // PUBLISH, QoS 1
  private static final int RETAINED = 0x33;

  private final TestManager broker = new TestManager();
  private final Connection service = broker.local("Service", new RecordingReceiver());

  @AfterEach
  void stop() {
    broker.close();
  }

  @Test
  void subscription_toWhatIsRetained_bringsItWithTheFlagAndNewOnesWithout() throws IOException {
    retain(GOALS, Channels.GOALS, GoalList::new);
    retain(ANNOUNCED, Channels.ACTUATORS, () -> announced("RUDDER"));
    try (RawClient late = new RawClient(broker.port).introduced("late")) {
      assertThat(late.subscribe(GOALS, 1)).isEqualTo(1);
      assertThat(late.next()).isEqualTo(RETAINED);

      publish(Channels.GOALS, new GoalList());
      assertThat(late.next()).isEqualTo(LIVE);

      late.subscribe(GOALS, 1); // once more: brings it again
      assertThat(late.next()).isEqualTo(RETAINED);
      publish(Channels.GOALS, new GoalList());
      assertThat(late.next()).isEqualTo(LIVE);

      late.subscribe(ANNOUNCED, 1);
      assertThat(late.next()).isEqualTo(RETAINED);
    }
  }

  @Test
  void subscription_toWhatAnotherClientRetained_bringsItWithTheFlag() throws IOException {
    try (RawClient elsewhere = new RawClient(broker.port).introduced("elsewhere");
        RawClient early = new RawClient(broker.port).introduced("early");
        RawClient late = new RawClient(broker.port).introduced("late")) {
      early.subscribe(GOALS, 1);
      elsewhere.publishRetained("u2sa/cessna/goals/GoalList", new GoalList().serialize());
      elsewhere.publishRetained("u2sa/cessna/goals/GoalList", new GoalList().serialize());
      assertThat(early.next()).isEqualTo(LIVE);
      assertThat(early.next()).isEqualTo(LIVE);

      late.subscribe(GOALS, 1);

      assertThat(late.next()).isEqualTo(RETAINED);
    }
  }

  /**
   * A message published in the moment of the subscription comes either as a new or as an old one.
   */
  @Test
  void subscription_inTheMomentOfTheFirstMessage_neverMissesIt() throws Exception {
    int topics = 250; // as many as a client may have filters
    ExecutorService publishing = Executors.newSingleThreadExecutor();
    try (RawClient publisher = new RawClient(broker.port).introduced("publisher");
        RawClient subscriber = new RawClient(broker.port).introduced("subscriber")) {
      for (int i = 0; i < topics; i++) {
        String topic = "u2sa/cessna/own-" + i + "/Tide";
        Future<Integer> acknowledged =
            publishing.submit(
                () -> {
                  publisher.publishRetained(topic, new byte[] {(byte) 0xa0});
                  return publisher.next();
                });
        subscriber.send(MqttPacketBytes.subscribeToEach(topic));
        List<Integer> heard = List.of(subscriber.next(), subscriber.next());
        assertThat(acknowledged.get()).isEqualTo(PUBACK);
        assertThat(heard).as(topic).containsAnyOf(LIVE, RETAINED).contains(SUBACK);
      }
    } finally {
      publishing.shutdown();
    }
  }

  /** Publishes twice: when somebody got the second one, the broker holds the first. */
  private void retain(String filter, Channel<?> channel, Supplier<U2SAData> message)
      throws IOException {
    try (RawClient witness = new RawClient(broker.port).introduced("witness")) {
      witness.subscribe(filter, 1);
      for (int i = 0; i < 2; i++) {
        publish(channel, message.get());
        assertThat(witness.next()).isEqualTo(LIVE);
      }
    }
  }

  private void publish(Channel<?> channel, U2SAData message) {
    assertThat(service.publish(channel, frozen(message))).isTrue();
  }

  private static ActuatorAnnouncement announced(String name) {
    return new ActuatorAnnouncement().actuatorName(name).minimum(-100.0).maximum(100.0);
  }
}
