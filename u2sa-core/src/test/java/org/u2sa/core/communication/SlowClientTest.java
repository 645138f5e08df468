package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import io.netty.buffer.Unpooled;
import java.util.Map;
import java.util.concurrent.Future;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.core.communication.routing.Publication;
import org.u2sa.core.communication.routing.TopicRoute;

/** What happens to a client that does not read or acknowledge what it is sent. */
class SlowClientTest {
  private static final String TOPIC = "u2sa/cessna/tide/Tide";
  private static final int MAX_UNACKNOWLEDGED_BYTES = 1 << 20;
  private static final int PATIENCE_S = 15;
  private static final Map<String, Object> LIMITS =
      Map.of(
          "MAX UNACKNOWLEDGED BYTES",
          MAX_UNACKNOWLEDGED_BYTES,
          "CLIENT PATIENCE",
          (double) PATIENCE_S);

  private final PacketPipeline client = new PacketPipeline(LIMITS).introduced();

  @AfterEach
  void close() {
    client.close();
  }

  private void subscribe() {
    client.send(MqttPacketBytes.subscribeToEach("u2sa/#"));
    client.sentPackets();
  }

  private void publish(boolean eachMatters, int bytes) {
    client.broker.router.send(TOPIC, eachMatters, false, new byte[bytes], () -> {});
    client.channel.runPendingTasks();
  }

  private void acknowledge(int identifier) {
    client.send(new byte[] {0x40, 2, (byte) (identifier >> 8), (byte) identifier});
  }

  private void assertIn() {
    assertThat(client.channel.isOpen()).as(client.log.toString()).isTrue();
  }

  private void assertPutOutFor(String reason) {
    assertThat(client.channel.isOpen()).isFalse();
    assertThat(client.log)
        .anyMatch(
            line ->
                line.startsWith("client disconnected: it is too slow: ") && line.contains(reason));
  }

  private Client.Owed owed() throws Exception {
    Future<Client.Owed> owed = client.session.owed();
    client.channel.runPendingTasks();
    return owed.get();
  }

  @Test
  void deliver_unconfirmedBeyondTheBacklog_isDroppedAndCounted() {
    subscribe();
    client.block();
    for (int i = 0; i < 5; i++) {
      publish(false, 100_000);
    }
    assertThat(client.broker.dropped()).isEqualTo(2);
    assertThat(client.log).anyMatch(line -> line.startsWith("message to a slow client dropped"));
    assertIn();

    client.unblock();
    assertThat(client.sentPackets()).isEqualTo(3);
    publish(false, 100_000);
    assertThat(client.sentPackets()).isEqualTo(1);
    assertThat(client.broker.dropped()).isEqualTo(2);
  }

  @Test
  void deliver_retainedOnes_mayFillMoreThanTheBacklogButNotAnyAmount() {
    for (int i = 0; i < 8; i++) {
      client.broker.router.send(TOPIC + i, true, true, new byte[200_000], () -> {});
    }
    client.channel.runPendingTasks();
    client.block();
    client.send(MqttPacketBytes.subscribe("u2sa/#"));
    assertThat(client.broker.dropped()).isEqualTo(2);

    client.unblock();
    assertThat(client.sentPackets()).isEqualTo(1 + 6);
    assertIn();
  }

  @Test
  void deliver_tooManyBytesOfConfirmedOnesUnread_putsTheClientOut() {
    subscribe();
    client.block();
    for (int i = 0; i < 6; i++) {
      publish(true, 200_000);
      assertIn();
    }
    publish(true, 200_000);
    assertPutOutFor("too many bytes are unacknowledged");
    publish(true, 1); // to a client that is gone
  }

  @Test
  void deliver_backlogOf64Kibibytes_saysThatTheClientIsBehind() {
    subscribe();
    client.block();
    Publication message =
        new Publication(new TopicRoute(TOPIC), Unpooled.wrappedBuffer(new byte[40_000]), false);
    assertThat(client.session.deliver(message, false)).isFalse();
    assertThat(client.session.deliver(message, false)).isTrue();
    assertThat(client.session.deliver(message, true)).isTrue();
    client.channel.runPendingTasks();

    client.unblock();
    assertThat(client.session.deliver(message, false)).isFalse();
    client.channel.runPendingTasks();
    message.release();
  }

  @Test
  void publish_subscriberIsBehind_publisherIsReadMoreSlowly() {
    subscribe();
    client.block();
    PacketPipeline publisher = new PacketPipeline(client).introduced("other");
    int acknowledgedAtOnce = acknowledgedOf(publisher);
    publish(false, 70_000);
    int acknowledgedThen = acknowledgedOf(publisher);
    publisher.close();

    assertThat(acknowledgedAtOnce).isEqualTo(100);
    assertThat(acknowledgedThen).isLessThan(100);
  }

  private static int acknowledgedOf(PacketPipeline publisher) {
    for (int i = 1; i <= 100; i++) {
      publisher.send(MqttPacketBytes.publish(TOPIC, 1, i));
    }
    return publisher.sentPackets();
  }

  @Test
  void look_readsNothing_isPutOutAfterItsPatienceOnly() {
    subscribe();
    client.passSeconds(2 * PATIENCE_S);
    client.block();
    publish(false, 10);
    client.passSeconds(PATIENCE_S);
    assertIn();

    client.passSeconds(2);
    assertPutOutFor("it does not read");
  }

  @Test
  void look_readsSomethingNowAndThen_stays() {
    subscribe();
    for (int i = 0; i < 10; i++) {
      publish(i % 2 == 0, 10);
      client.unblock();
      client.sentIdentifiers().forEach(this::acknowledge);
      client.block();
      publish(false, 10);
      client.passSeconds(PATIENCE_S - 1);
      assertIn();
    }
  }

  @Test
  void look_readsOnlyAnswers_stays() {
    for (int i = 1; i < 10; i++) {
      client.block();
      client.send(MqttPacketBytes.publish(TOPIC, 1, i));
      client.passSeconds(PATIENCE_S - 1);
      assertIn();
      client.unblock();
    }
    client.block();
    client.send(MqttPacketBytes.publish(TOPIC, 1, 10));
    client.passSeconds(PATIENCE_S + 2);
    assertPutOutFor("it does not read");
  }

  @Test
  void look_acknowledgesNothing_isPutOutAfterItsPatienceSinceTheOldest() {
    subscribe();
    publish(true, 10);
    int first = client.sentIdentifiers().get(0);
    client.passSeconds(10);
    publish(true, 10);
    acknowledge(first);
    client.passSeconds(PATIENCE_S);
    assertIn();

    client.passSeconds(2);
    assertPutOutFor("it does not acknowledge");
  }

  @Test
  void look_acknowledgesAll_stays() {
    subscribe();
    publish(true, 10);
    client.sentIdentifiers().forEach(this::acknowledge);
    client.passSeconds(3 * PATIENCE_S);
    assertIn();
  }

  @Test
  void look_othersPublishedTooMuchSinceTheOldestUnacknowledged_isPutOut() {
    subscribe();
    client.broker.keep(5 * MAX_UNACKNOWLEDGED_BYTES);
    publish(true, 10);
    client.broker.keep(MAX_UNACKNOWLEDGED_BYTES);
    client.passSeconds(1);
    assertIn();

    client.broker.keep(1);
    client.passSeconds(1);
    assertPutOutFor("too many bytes are unacknowledged");
  }

  @Test
  void owed_countsWhatIsUnsentOrUnacknowledged() throws Exception {
    subscribe();
    client.pass(1_000);
    client.block();
    publish(false, 10);
    publish(false, 10);
    publish(true, 10);
    long sent = client.broker.nowMicros();
    client.pass(1);
    assertThat(owed()).isEqualTo(new Client.Owed(3, sent));

    client.unblock();
    assertThat(owed()).isEqualTo(new Client.Owed(1, sent));
    acknowledge(client.sentIdentifiers().get(0));
    assertThat(owed()).isEqualTo(new Client.Owed(0, sent));
  }

  @Test
  void channelRead_manyAnswersUnread_waitsUntilTheyAreRead() {
    client.readNothing();
    for (int i = 1; i <= 600; i++) {
      client.send(MqttPacketBytes.publish(TOPIC, 1, i));
    }
    assertThat(client.read()).isEqualTo(513);
    client.pass(10);
    assertThat(client.sentPackets()).isEqualTo(600);
  }

  @Test
  void budget_backlogsOfAllTogether_costTheOneWithTheMost() {
    long limit = Math.min(256 << 20, Runtime.getRuntime().maxMemory() / 4);
    PacketPipeline other = new PacketPipeline(client).introduced("other");
    subscribe();
    client.block();
    client.broker.unsent.set(other.session, limit - 70_000);
    publish(false, 60_000);
    other.pass(1);
    assertThat(other.channel.isOpen()).as("a small backlog does not count").isTrue();

    client.unblock();
    client.block();
    publish(false, 60_000);
    publish(false, 60_000);
    other.pass(1);
    assertThat(other.channel.isOpen()).isFalse();
    assertIn();
  }

  @Test
  void budget_backlogRead_countsNoLonger() {
    long limit = Math.min(256 << 20, Runtime.getRuntime().maxMemory() / 4);
    subscribe();
    client.block();
    publish(false, 120_000);
    client.unblock();
    client.passSeconds(1);

    PacketPipeline other = new PacketPipeline(client).introduced("other");
    client.broker.unsent.set(other.session, limit);
    other.pass(1);
    assertThat(other.channel.isOpen()).isTrue();
    other.close();
  }
}
