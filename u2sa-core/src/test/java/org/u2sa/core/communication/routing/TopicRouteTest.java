package org.u2sa.core.communication.routing;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Who gets what is published on a topic. */
class TopicRouteTest {
  private static final String TOPIC = "u2sa/cessna/state/StateInformation";

  private final RemoteSubscriptions subscriptions = new RemoteSubscriptions();

  @Test
  void listeners_severalFiltersOfOneConnection_isOneWithTheHighestQuality() {
    TopicRoute route = subscriptions.route(TOPIC);
    subscriptions.add("1", "screen", "u2sa/#", false);
    subscriptions.add("1", "screen", "u2sa/cessna/state/#", true);
    subscriptions.add("2", "screen", "u2sa/+/state/+", false);
    subscriptions.add("3", "screen", "u2sa/boat/#", true);

    assertThat(route.listeners())
        .containsExactly(new TopicRoute.Listener("1", true), new TopicRoute.Listener("2", false));

    subscriptions.remove("1", "u2sa/cessna/state/#");
    assertThat(route.listeners())
        .containsExactly(new TopicRoute.Listener("1", false), new TopicRoute.Listener("2", false));
    subscriptions.remove("1");
    subscriptions.remove("2");
    assertThat(route.listeners()).isEmpty();
    assertThat(route.isWanted()).isFalse();
  }

  @Test
  void listeners_sameFilterAgainWithAnotherQuality_theNewOneCounts() {
    subscriptions.add("1", "screen", "u2sa/#", false);
    subscriptions.add("1", "screen", "u2sa/#", true);

    assertThat(subscriptions.route(TOPIC).listeners())
        .containsExactly(new TopicRoute.Listener("1", true));
    assertThat(subscriptions.ofUser("screen")).isEqualTo(1);
  }

  @Test
  void route_ofMoreTopicsThanAreRemembered_theLeastRecentlyUsedIsComparedAgain() {
    subscriptions.add("1", "screen", "u2sa/#", false);
    TopicRoute first = subscriptions.route(TOPIC);
    for (int i = 1; i < 4_096; i++) {
      subscriptions.route(TOPIC + i);
    }
    assertThat(subscriptions.route(TOPIC)).isSameAs(first);
    assertThat(subscriptions.isRemembered(TOPIC + 1)).isTrue();

    subscriptions.route("u2sa/one/more");

    assertThat(subscriptions.isRemembered(TOPIC)).isTrue();
    assertThat(subscriptions.isRemembered(TOPIC + 1)).isFalse();
    assertThat(subscriptions.route(TOPIC + 1).listeners())
        .containsExactly(new TopicRoute.Listener("1", false));
    assertThat(subscriptions.topics()).isEqualTo(4_096);
  }
}
