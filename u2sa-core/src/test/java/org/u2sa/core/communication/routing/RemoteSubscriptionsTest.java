package org.u2sa.core.communication.routing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

/** What is wanted, and what it costs the services to know that. */
class RemoteSubscriptionsTest {
  private static final String TOPIC = "u2sa/cessna/state/StateInformation";

  private final AtomicInteger compared = new AtomicInteger();
  private final RemoteSubscriptions subscriptions =
      new RemoteSubscriptions(
          (topic, filter) -> {
            compared.incrementAndGet();
            return topic.match(filter);
          });

  @Test
  void wants_asLongAsAnyConnectionListens() {
    assertThat(subscriptions.wants(TOPIC)).isFalse();
    subscriptions.add("1", "screen", "u2sa/cessna/state/#", false);
    subscriptions.add("1", "screen", "u2sa/cessna/state/#", false);
    subscriptions.add("2", "screen", "u2sa/cessna/state/#", false);
    assertThat(subscriptions.wants(TOPIC)).isTrue();
    subscriptions.remove("1");
    assertThat(subscriptions.wants(TOPIC)).isTrue();
    subscriptions.add("3", "screen", "u2sa/+/state/+", false);
    subscriptions.remove("2", "u2sa/cessna/state/#");
    assertThat(subscriptions.wants(TOPIC)).isTrue();
    subscriptions.remove("3");
    assertThat(subscriptions.wants(TOPIC)).isFalse();
    assertThat(subscriptions.wants(TOPIC + "/AircraftState")).isFalse();
  }

  @Test
  void wants_afterEachOfManyChanges_comparesNothingOnTheServicesThread() {
    for (int i = 0; i < 5_000; i++) {
      subscriptions.add("connection " + i / 200, "screen", "u2sa/cessna/state/Type" + i, false);
    }
    assertThat(subscriptions.wants(TOPIC)).isFalse();
    int version = subscriptions.version();
    int before = compared.get();
    for (int i = 0; i < 100; i++) {
      subscriptions.add("churn", "screen", "u2sa/cessna/goals/#", false);
      int onTheClientsThread = compared.get();
      assertThat(subscriptions.wants(TOPIC)).isFalse();
      assertThat(compared.get()).isEqualTo(onTheClientsThread);
      subscriptions.remove("churn", "u2sa/cessna/goals/#");
    }
    assertThat(subscriptions.version()).isGreaterThan(version);
    assertThat(compared.get() - before).isEqualTo(2 * 100); // a topic, a change
  }

  @Test
  void ofUser_countsAllConnections() {
    subscriptions.add("1", "screen", "a/#", false);
    subscriptions.add("2", "screen", "a/#", false);
    subscriptions.add("3", "pilot", "b/#", false);
    assertThat(subscriptions.ofUser("screen")).isEqualTo(2);
    subscriptions.remove("2");
    assertThat(subscriptions.ofUser("screen")).isEqualTo(1);
    subscriptions.remove("1", "a/#");
    subscriptions.remove("1", "a/#");
    assertThat(subscriptions.ofUser("screen")).isZero();
  }

  /** A client that leaves with many filters must not hold the others up. */
  @Test
  void remove_connectionWithManyFilters_comparesNothing() {
    for (int i = 0; i < 100; i++) {
      subscriptions.wants("u2sa/cessna/state/Type" + i);
      subscriptions.add("1", "screen", "u2sa/+/state/Type" + i, false);
    }
    subscriptions.add("2", "screen", "u2sa/cessna/state/Type7", false);
    int before = compared.get();

    subscriptions.remove("1");

    assertThat(compared.get()).isEqualTo(before);
    assertThat(subscriptions.wants("u2sa/cessna/state/Type8")).isFalse();
    assertThat(subscriptions.wants("u2sa/cessna/state/Type7")).isTrue();
    assertThat(subscriptions.route("u2sa/cessna/state/Type7").listeners())
        .containsExactly(new TopicRoute.Listener("2", false));
    assertThat(subscriptions.ofUser("screen")).isEqualTo(1);
  }
}
