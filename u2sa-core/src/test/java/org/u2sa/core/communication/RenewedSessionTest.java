package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.frozen;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/** What a client does on a new session, step by step, with a broker that does as the test says. */
@Timeout(120)
class RenewedSessionTest {
  private static final String REPORTS = Topic.filter("cessna", Channels.GOAL_REPORTS);
  private static final String COMMANDS = Topic.filter("cessna", Channels.GOAL_COMMANDS);

  private final RecordingReceiver receiver = new RecordingReceiver();
  private ScriptedBroker broker;
  private Connection client;

  @BeforeEach
  void connect() throws IOException {
    broker = new ScriptedBroker();
    client = TestManager.transport(broker.port()).connect("MissionManager", receiver);
  }

  @AfterEach
  void close() throws IOException {
    client.close();
    broker.close();
  }

  private static GoalList goals(String uid) {
    Waypoint goal = new Waypoint();
    goal.uid(uid).horizontalThreshold(1.0).verticalThreshold(1.0);
    return frozen(new GoalList().goals(List.of(goal)));
  }

  private U2SAData held(U2SAData like) {
    Topic topic = Topic.of("cessna", Channels.GOALS, like);
    byte[] payload = broker.retained.get(topic.toString());
    try {
      return payload == null
          ? null
          : new MessageCodec(StandardTypes.registry()).decode(topic.typeChain(), payload);
    } catch (MalformedMessageException e) {
      throw new AssertionError(e);
    }
  }

  /** Publishes while the broker has not yet confirmed the new session's subscription. */
  private void publishWithinNextRenewal(GoalList message) {
    AtomicBoolean first = new AtomicBoolean(true);
    broker.beforeAnswer(
        filter -> {
          if (filter.equals(REPORTS) && first.getAndSet(false)) {
            assertThat(client.publish(Channels.GOALS, message)).isFalse(); // no session yet
          }
        });
  }

  @Test
  void publishRetained_betweenSnapshotAndUseOfTheNewSession_brokerHoldsIt() throws IOException {
    client.subscribe(Channels.GOAL_REPORTS);
    client.publish(Channels.GOALS, goals("first"));
    soon().until(() -> goals("first").equals(held(goals("first"))));
    publishWithinNextRenewal(goals("second"));

    broker.cut();

    soon().until(() -> goals("second").equals(held(goals("second"))));
  }

  @Test
  void publishRetained_firstEverWithinTheRenewal_brokerHoldsIt() throws IOException {
    client.subscribe(Channels.GOAL_REPORTS);
    publishWithinNextRenewal(goals("first"));

    broker.cut();

    soon().until(() -> goals("first").equals(held(goals("first"))));
  }

  @Test
  void reconnect_oneSubscriptionRefused_keepsTheOthersAndAsksAgainNextTime() throws IOException {
    client.subscribe(Channels.GOAL_COMMANDS);
    client.subscribe(Channels.GOAL_REPORTS);
    broker.refused.add(COMMANDS);

    broker.cut();
    receiver.awaitTrouble("restored");

    assertThat(receiver.troubles)
        .anyMatch(line -> line.contains("rejects the subscription to \"goal-commands\""));
    assertThat(client.publish(Channels.GOALS, goals("first"))).isTrue();
    assertThat(client.refusedSubscriptions()).containsExactly("goal-commands");
    long asked = timesAsked(COMMANDS);

    broker.refused.clear();
    broker.cut();

    soon().until(() -> client.refusedSubscriptions().isEmpty());
    assertThat(timesAsked(COMMANDS)).isEqualTo(asked + 1);
  }

  private long timesAsked(String filter) {
    return broker.subscribed.stream().filter(filter::equals).count();
  }

  @Test
  void subscribe_refused_saysSoAndGoesOn() throws IOException {
    broker.refused.add(COMMANDS);

    assertThat(client.subscribe(Channels.GOAL_COMMANDS)).isFalse();
    assertThat(client.subscribe(Channels.GOAL_REPORTS)).isTrue();
    assertThat(client.refusedSubscriptions()).containsExactly("goal-commands");

    broker.cut();

    receiver.awaitTrouble("subscriptions except [goal-commands]");
  }

  @Test
  void reconnect_hundredsOfRetainedTopics_asksInPacketsThatOurBrokerTakes() throws IOException {
    List<ActuatorAnnouncement> all = new ArrayList<>();
    for (int i = 0; i < 300; i++) {
      String name = "ACTUATOR WITH A LONG NAME, NUMBER " + i;
      all.add(frozen(new ActuatorAnnouncement().actuatorName(name).minimum(0.0).maximum(1.0)));
    }
    all.forEach(one -> client.publish(Channels.ACTUATORS, one));
    soon().until(() -> broker.retained.size() == 300);
    String lost = Topic.of("cessna", Channels.ACTUATORS, all.get(150)).toString();
    broker.retained.remove(lost);

    broker.cut();
    receiver.awaitTrouble("restored");

    assertThat(broker.longestRequest.get()).isBetween(1, BrokerLimits.LONGEST_CONTROL_PACKET);
    assertThat(broker.subscribed).hasSize(300).doesNotHaveDuplicates();
    soon().until(() -> broker.retained.containsKey(lost));
  }

  @Test
  void reconnect_receiverFailsAtEachReport_comesBackAllTheSame() throws IOException {
    client.close();
    client =
        TestManager.transport(broker.port())
            .connect(
                "MissionManager",
                new Receiver() {
                  @Override
                  public void receive(Channel<?> channel, U2SAData message) {
                    receiver.receive(channel, message);
                  }

                  @Override
                  public void trouble(String what) {
                    receiver.trouble(what);
                    throw new IllegalStateException("odd");
                  }
                });
    client.publish(Channels.GOALS, goals("first"));
    for (int i = 0; i < 3; i++) {
      broker.cut();
      String uid = "after cut " + i;
      soon().dontCatchUncaughtExceptions().until(() -> client.publish(Channels.GOALS, goals(uid)));
      soon().dontCatchUncaughtExceptions().until(() -> goals(uid).equals(held(goals(uid))));
    }
  }

  @Test
  void reconnect_mayNotAskForWhatItPublished_comesBackAllTheSame() throws IOException {
    client.publish(Channels.GOALS, goals("first"));
    broker.refused.add(Topic.of("cessna", Channels.GOALS, goals("first")).toString());
    soon().until(() -> goals("first").equals(held(goals("first"))));

    broker.cut();

    receiver.awaitTrouble("restored");
    assertThat(receiver.troubles).noneMatch(line -> line.contains("cannot reconnect"));
  }
}
