package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What a subscriber gets of what is retained, before, while and after it subscribes. */
class RetainedOrderTest {
  private static final String TOPIC = "u2sa/cessna/tide/Tide";
  private static final String EMPTY_MAP = "\u00a0"; // of CBOR
  private static final String SUBACK = "90";
  private static final String PUBACK = "40";
  private static final String NEW = "32 ";
  private static final String RETAINED = "33 ";

  private final PacketPipeline pipeline = new PacketPipeline().introduced();

  @AfterEach
  void close() {
    pipeline.close();
  }

  /** A message of this process, which the network's thread has not seen yet. */
  private void publishLocally(String payload) {
    byte[] bytes = payload.getBytes(StandardCharsets.ISO_8859_1);
    pipeline.broker.router.send(TOPIC, true, true, bytes, () -> {});
  }

  @Test
  void subscribe_publishedBefore_isRetained() {
    publishLocally("a");
    pipeline.pass(1);
    pipeline.send(MqttPacketBytes.subscribeToEach("u2sa/#"));

    assertThat(pipeline.sent()).containsExactly(SUBACK, RETAINED + "a");
  }

  @Test
  void subscribe_publishedMeanwhile_isNewAndComesOnce() {
    publishLocally("a"); // waits for the thread that reads the subscription first
    pipeline.send(MqttPacketBytes.subscribeToEach("u2sa/#"));

    assertThat(pipeline.sent()).containsExactly(SUBACK, NEW + "a");
  }

  @Test
  void subscribe_changedMeanwhile_theNewOneIsTheLast() {
    publishLocally("a");
    pipeline.pass(1);
    publishLocally("b");
    pipeline.send(MqttPacketBytes.subscribeToEach("u2sa/#"));

    assertThat(pipeline.sent()).containsExactly(SUBACK, RETAINED + "a", NEW + "b");
  }

  @Test
  void subscribe_retainedByAClient_bringsTheLastOne() {
    pipeline.send(MqttPacketBytes.retained(TOPIC, EMPTY_MAP));
    pipeline.send(MqttPacketBytes.subscribeToEach("u2sa/cessna/#"));

    assertThat(pipeline.sent()).containsExactly(PUBACK, SUBACK, RETAINED + EMPTY_MAP);
  }

  @Test
  void subscribe_severalFiltersMatch_bringsItOnceWithTheHigherQuality() {
    publishLocally("a");
    pipeline.pass(1);
    pipeline.send(MqttPacketBytes.subscribe("u2sa/cessna/#", "u2sa/+/tide/#"));
    assertThat(pipeline.sent()).containsExactly(SUBACK, "31 a");
  }

  @Test
  void publish_emptyAndRetained_deletes() {
    publishLocally("a");
    pipeline.pass(1);
    pipeline.send(MqttPacketBytes.retained(TOPIC, ""));
    pipeline.send(MqttPacketBytes.subscribeToEach("u2sa/#"));

    assertThat(pipeline.sent()).containsExactly(PUBACK, SUBACK);
  }

  @Test
  void subscribe_sharedOrNoFilter_isRefusedAndBringsNothing() {
    publishLocally("a");
    pipeline.pass(1);
    pipeline.send(MqttPacketBytes.subscribeToEach("$share/x/u2sa/#"));
    pipeline.send(MqttPacketBytes.subscribeToEach("u2sa/#/x"));
    publishLocally("b");
    pipeline.pass(1);

    assertThat(pipeline.sent()).containsExactly(SUBACK, SUBACK);
  }

  @Test
  void unsubscribe_isAnsweredAndNothingFollows() {
    pipeline.send(MqttPacketBytes.subscribeToEach("u2sa/#"));
    pipeline.send(MqttPacketBytes.unsubscribe("u2sa/#"));
    publishLocally("a");
    pipeline.pass(1);

    assertThat(pipeline.sent()).containsExactly(SUBACK, "b0");
  }
}
