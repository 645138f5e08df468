package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import io.netty.buffer.Unpooled;
import io.netty.handler.codec.mqtt.MqttMessage;
import io.netty.handler.codec.mqtt.MqttMessageBuilders;
import io.netty.handler.codec.mqtt.MqttQoS;
import io.netty.handler.codec.mqtt.MqttSubscribeMessage;
import io.netty.handler.codec.mqtt.MqttUnsubscribeMessage;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.core.communication.access.LocalAccount;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.core.communication.routing.TopicRoute;

/** Subscriptions of one client, and how many questions they count as. */
class ClientSubscriptionsTest {
  private static final String TOPIC = PacketPipeline.TOPIC;

  private final PacketPipeline pipeline = new PacketPipeline();
  private final BrokerState broker = pipeline.broker;
  private final ClientSubscriptions subscriptions = of("connection");

  @AfterEach
  void close() {
    pipeline.close();
  }

  private ClientSubscriptions of(String connection) {
    PacketRules rules = new PacketRules(broker, null, "client");
    return new ClientSubscriptions(broker, rules, LocalAccount.ANONYMOUS, connection);
  }

  private static MqttSubscribeMessage subscribe(MqttQoS quality, List<String> filters) {
    MqttMessageBuilders.SubscribeBuilder builder = MqttMessageBuilders.subscribe().messageId(7);
    filters.forEach(filter -> builder.addSubscription(quality, filter));
    return builder.build();
  }

  private static MqttUnsubscribeMessage unsubscribe(String... filters) {
    MqttMessageBuilders.UnsubscribeBuilder builder = MqttMessageBuilders.unsubscribe().messageId(7);
    List.of(filters).forEach(builder::addTopicFilter);
    return builder.build();
  }

  private static List<String> different(String prefix, int count) {
    return IntStream.range(0, count).mapToObj(i -> prefix + i).toList();
  }

  @Test
  void refusalOf_asManyFiltersAsAllowed_entersThemAllAndNoneMore() {
    int most = BrokerLimits.FILTERS_PER_CLIENT;
    assertThat(subscriptions.refusalOf(subscribe(MqttQoS.AT_MOST_ONCE, different("a", most))))
        .isEmpty();
    assertThat(broker.subscriptions.ofUser(LocalAccount.ANONYMOUS)).isEqualTo(most);

    assertThat(subscriptions.refusalOf(subscribe(MqttQoS.AT_MOST_ONCE, List.of("b"))))
        .contains("it has too many filters");
    assertThat(subscriptions.refusalOf(subscribe(MqttQoS.AT_MOST_ONCE, List.of("a0")))).isEmpty();
    assertThat(broker.subscriptions.ofUser(LocalAccount.ANONYMOUS)).isEqualTo(most);
  }

  @Test
  void refusalOf_oneTooManyInAPacket_entersNone() {
    List<String> tooMany = different("a", BrokerLimits.FILTERS_PER_CLIENT + 1);
    assertThat(subscriptions.refusalOf(subscribe(MqttQoS.AT_MOST_ONCE, tooMany))).isPresent();
    assertThat(broker.subscriptions.ofUser(LocalAccount.ANONYMOUS)).isZero();
  }

  @Test
  void refusalOf_filtersOfAllConnectionsOfAUser_areCountedTogether() {
    int clients = BrokerLimits.FILTERS_PER_USER / BrokerLimits.FILTERS_PER_CLIENT;
    for (int i = 0; i < clients; i++) {
      List<String> filters = different(i + "/", BrokerLimits.FILTERS_PER_CLIENT);
      assertThat(of("connection " + i).refusalOf(subscribe(MqttQoS.AT_MOST_ONCE, filters)))
          .isEmpty();
    }
    assertThat(subscriptions.refusalOf(subscribe(MqttQoS.AT_MOST_ONCE, List.of("a"))))
        .contains("its user has too many filters");
  }

  @Test
  void refusalOf_filterThatIsNoneOrTooLong_isRefused() {
    assertThat(subscriptions.refusalOf(subscribe(MqttQoS.AT_MOST_ONCE, List.of("a", "a/#/b"))))
        .contains("a filter is invalid");
    assertThat(subscriptions.refusalOf(subscribe(MqttQoS.AT_MOST_ONCE, List.of("x".repeat(1_025)))))
        .contains("a filter is too long");
    assertThat(subscriptions.refusalOf(subscribe(MqttQoS.AT_MOST_ONCE, List.of("/".repeat(32)))))
        .contains("a filter is too long");
    assertThat(subscriptions.refusalOf(subscribe(MqttQoS.AT_MOST_ONCE, List.of("/".repeat(31)))))
        .isEmpty();
    assertThat(subscriptions.refusalOf(subscribe(MqttQoS.AT_MOST_ONCE, List.of("x".repeat(1_024)))))
        .isEmpty();
  }

  /** Each change of quality would compare the filter with every topic again. */
  @Test
  void refusalOf_oneFilterAgainAndAgain_isEnteredOnceWithTheLastQuality() {
    broker.subscriptions.wants(TOPIC);
    MqttMessageBuilders.SubscribeBuilder packet = MqttMessageBuilders.subscribe().messageId(7);
    for (int i = 0; i < 1_000; i++) {
      packet.addSubscription(i % 2 == 0 ? MqttQoS.AT_MOST_ONCE : MqttQoS.AT_LEAST_ONCE, "u2sa/#");
    }
    int version = broker.subscriptions.version();

    assertThat(subscriptions.refusalOf(packet.build())).isEmpty();

    assertThat(broker.subscriptions.version()).isEqualTo(version + 1);
    assertThat(broker.subscriptions.route(TOPIC).listeners())
        .containsExactly(new TopicRoute.Listener("connection", true));
  }

  @Test
  void unsubscribe_knownAndUnknownFilters_endsTheKnownOnesOnly() {
    broker.subscriptions.wants(TOPIC);
    subscriptions.refusalOf(subscribe(MqttQoS.AT_LEAST_ONCE, List.of("u2sa/#", "u2sa/+/state/#")));

    subscriptions.unsubscribe(unsubscribe("x", "u2sa/#", "u2sa/cessna/#", "u2sa/#"));
    assertThat(broker.subscriptions.wants(TOPIC)).isTrue();
    assertThat(broker.subscriptions.ofUser(LocalAccount.ANONYMOUS)).isEqualTo(1);

    subscriptions.unsubscribe(unsubscribe("u2sa/+/state/#"));
    assertThat(broker.subscriptions.wants(TOPIC)).isFalse();
    assertThat(broker.subscriptions.ofUser(LocalAccount.ANONYMOUS)).isZero();
  }

  @Test
  void unsubscribe_makesRoomForOthers() {
    int most = BrokerLimits.FILTERS_PER_CLIENT;
    subscriptions.refusalOf(subscribe(MqttQoS.AT_MOST_ONCE, different("a", most)));
    subscriptions.unsubscribe(unsubscribe("a0"));

    assertThat(subscriptions.refusalOf(subscribe(MqttQoS.AT_MOST_ONCE, List.of("b")))).isEmpty();
  }

  /** One client's shared subscription must not change the way of everybody's messages. */
  @Test
  void refusalOf_sharedFilter_isRefused() {
    assertThat(subscriptions.refusalOf(subscribe(MqttQoS.AT_MOST_ONCE, List.of("$share/x/u2sa/#"))))
        .contains("a filter is shared");
  }

  @Test
  void questions_countByFiltersAndTheTopicsTheyAreComparedWith() {
    List<String> filters = Collections.nCopies(101, "a");
    assertThat(subscriptions.questions(subscribe(MqttQoS.AT_MOST_ONCE, filters))).isEqualTo(1.0);
    for (int i = 0; i < 2_048; i++) {
      broker.subscriptions.wants("u2sa/cessna/state/Type" + i);
    }
    assertThat(subscriptions.questions(subscribe(MqttQoS.AT_MOST_ONCE, filters))).isEqualTo(51.0);
    assertThat(subscriptions.questions(unsubscribe("a", "b", "c"))).isEqualTo(2.0);
    assertThat(subscriptions.questions(unsubscribe("a"))).isEqualTo(1.0);
  }

  @Test
  void answerTo_grantsAtMostOneOrRefusesEach() {
    MqttSubscribeMessage packet =
        MqttMessageBuilders.subscribe()
            .messageId(9)
            .addSubscription(MqttQoS.AT_MOST_ONCE, "a")
            .addSubscription(MqttQoS.AT_LEAST_ONCE, "b")
            .addSubscription(MqttQoS.EXACTLY_ONCE, "c")
            .build();

    assertThat(ClientSubscriptions.answerTo(packet, false).payload().grantedQoSLevels())
        .containsExactly(0, 1, 1);
    assertThat(ClientSubscriptions.answerTo(packet, true).payload().grantedQoSLevels())
        .containsExactly(0x80, 0x80, 0x80);
    assertThat(ClientSubscriptions.answerTo(packet, true).variableHeader().messageId())
        .isEqualTo(9);
  }

  /** Who asks for everything that is retained, again and again, has to wait. */
  @Test
  void sendRetained_manyMessages_countAsQuestions() {
    for (int i = 0; i < 640; i++) {
      broker.retained.enterLocal("u2sa/cessna/own/Tide" + i, new byte[] {1});
    }
    pipeline.introduced();
    MqttSubscribeMessage all = subscribe(MqttQoS.AT_MOST_ONCE, List.of("u2sa/#"));
    for (int i = 0; i < 5; i++) {
      assertThat(subscriptions.isInTurn(unsubscribe("x"))).isTrue();
      subscriptions.sendRetained(all, pipeline.session);
    }
    assertThat(subscriptions.isInTurn(unsubscribe("x"))).isFalse();
  }

  private static MqttMessage message(String topic) {
    return MqttMessageBuilders.publish()
        .topicName(topic)
        .qos(MqttQoS.AT_MOST_ONCE)
        .payload(Unpooled.EMPTY_BUFFER)
        .build();
  }

  private int newTopicsInTurn(ClientSubscriptions client, int most) {
    int taken = 0;
    while (taken < most && client.isInTurn(message(TOPIC + taken))) {
      taken++;
    }
    return taken;
  }

  /** The network's thread compares each new topic with every broker, whoever invents topics. */
  @Test
  void isInTurn_newTopics_areLimitedByTheFiltersTheyAreComparedWith() {
    assertThat(newTopicsInTurn(subscriptions, 10_000)).as("nobody listens").isEqualTo(10_000);
    subscriptions.refusalOf(subscribe(MqttQoS.AT_MOST_ONCE, different("a", 250)));

    assertThat(newTopicsInTurn(subscriptions, 10_000)).isEqualTo(50_000 / 250);
    assertThat(newTopicsInTurn(of("another"), 10_000)).as("of its own").isEqualTo(50_000 / 250);
    pipeline.pass(100);
    assertThat(newTopicsInTurn(subscriptions, 10_000)).isEqualTo(25_000 / 250 / 10);
    broker.subscriptions.route(TOPIC);
    assertThat(subscriptions.isInTurn(message(TOPIC))).as("a known topic").isTrue();
  }

  @Test
  void isInTurn_questions_areLimitedForAllConnectionsOfTheUser() {
    int taken = 0;
    while (of("connection " + taken).isInTurn(message("u2sa/x/discovery/DiscoveryRequest"))) {
      taken++;
    }
    assertThat(taken).isEqualTo(200 / 4);
    assertThat(subscriptions.isInTurn(unsubscribe("a"))).isFalse();
    assertThat(subscriptions.isInTurn(message(TOPIC))).isTrue();
  }

  @Test
  void questions_messages_countIfEveryServiceAnswersThem() {
    MqttMessageBuilders.PublishBuilder publish =
        MqttMessageBuilders.publish().qos(MqttQoS.AT_MOST_ONCE).payload(Unpooled.EMPTY_BUFFER);
    assertThat(subscriptions.questions(publish.topicName(TOPIC).build())).isZero();
    assertThat(
            subscriptions.questions(
                publish.topicName("u2sa/cessna/discovery/DiscoveryRequest").build()))
        .isEqualTo(1.0);
  }
}
