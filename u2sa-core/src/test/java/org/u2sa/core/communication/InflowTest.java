package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.embedded.EmbeddedChannel;
import io.netty.handler.codec.mqtt.MqttFixedHeader;
import io.netty.handler.codec.mqtt.MqttMessageBuilders;
import io.netty.handler.codec.mqtt.MqttMessageIdVariableHeader;
import io.netty.handler.codec.mqtt.MqttMessageType;
import io.netty.handler.codec.mqtt.MqttPubAckMessage;
import io.netty.handler.codec.mqtt.MqttQoS;
import io.netty.util.ReferenceCountUtil;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;

/** How fast a client is read. */
class InflowTest {
  private long nowMicros;

  /** Time as this test has it; nobody waits. */
  private final class TestClock implements Clock {
    @Override
    public long micros() {
      return nowMicros;
    }

    @Override
    public Waiter newWaiter(String name) {
      throw new IllegalStateException(name + " does not wait");
    }
  }

  private final BrokerState filter = filter(Map.of());
  private final Inflow inflow = new Inflow(filter, new ClientSession(filter, new Outflow(filter)));
  private final EmbeddedChannel channel = new EmbeddedChannel(inflow);

  private BrokerState filter(Map<String, Object> variables) {
    return new BrokerState(
        XmlConfiguration.inMemory("test", variables).settings(BrokerLimits.class).get(),
        new MessageCodec(StandardTypes.registry()),
        new TestClock(),
        null,
        line -> {});
  }

  private static EmbeddedChannel clientOf(BrokerState broker) {
    return new EmbeddedChannel(new Inflow(broker, new ClientSession(broker, new Outflow(broker))));
  }

  @AfterEach
  void close() {
    channel.finishAndReleaseAll();
  }

  private void send(int messages) {
    send(channel, messages);
  }

  private static void send(EmbeddedChannel channel, int messages) {
    for (int i = 0; i < messages; i++) {
      channel.writeInbound(
          MqttMessageBuilders.publish()
              .topicName("u2sa/cessna/state/StateInformation")
              .qos(MqttQoS.AT_MOST_ONCE)
              .payload(Unpooled.wrappedBuffer(new byte[100]))
              .build());
    }
  }

  private void pass(int milliseconds) {
    pass(channel, milliseconds);
  }

  private void pass(EmbeddedChannel channel, int milliseconds) {
    nowMicros += 1_000L * milliseconds;
    channel.advanceTimeBy(milliseconds, TimeUnit.MILLISECONDS);
    channel.runScheduledPendingTasks();
  }

  private int letIn() {
    return letIn(channel);
  }

  private static int letIn(EmbeddedChannel channel) {
    int count = 0;
    for (Object message = channel.readInbound(); message != null; message = channel.readInbound()) {
      ReferenceCountUtil.release(message);
      count++;
    }
    return count;
  }

  @Test
  void channelRead_subscribersKeepUp_allAtOnce() {
    send(1_000);

    assertThat(letIn()).isEqualTo(1_000);
    assertThat(channel.config().isAutoRead()).isTrue();
  }

  @Test
  void channelRead_subscriberIsBehind_aTenthOfTheRateAndNothingIsLost() {
    inflow.subscriberIsBehind(true);
    send(1_000);

    assertThat(letIn()).isEqualTo(20);
    assertThat(channel.config().isAutoRead()).isFalse();
    int inTenMilliseconds = 0;
    for (int i = 0; i < 5; i++) {
      pass(2);
      inTenMilliseconds += letIn();
    }
    assertThat(inTenMilliseconds).isEqualTo(100);

    inflow.subscriberIsBehind(false);
    pass(2);
    assertThat(letIn()).isEqualTo(1_000 - 20 - 100);
    assertThat(channel.config().isAutoRead()).isTrue();
  }

  @Test
  void channelRead_othersFlood_togetherTheyGetTheTotalAndNobodyWaitsForItsShare() {
    BrokerState crowded =
        filter(Map.of("CLIENT MESSAGES PER SECOND", 100_000, "TOTAL MESSAGES PER SECOND", 10_000));
    EmbeddedChannel flood = clientOf(crowded);
    EmbeddedChannel other = clientOf(crowded);
    EmbeddedChannel modest = clientOf(crowded);

    send(flood, 1_000);
    send(other, 1_000);
    assertThat(letIn(flood)).as("share and the total's burst").isEqualTo(20 + 100);
    assertThat(letIn(other)).as("share").isEqualTo(20);

    pass(flood, 10);
    send(modest, 10);
    assertThat(letIn(modest)).isEqualTo(10);
    assertThat(letIn(flood)).as("share and total of 10 ms").isEqualTo(10 + 100);
    for (EmbeddedChannel each : List.of(flood, other, modest)) {
      each.finishAndReleaseAll();
    }
  }

  /** A client each of whose messages takes the network's thread so long. */
  private EmbeddedChannel clientOf(BrokerState broker, int millisecondsPerMessage) {
    return new EmbeddedChannel(
        new Inflow(broker, new ClientSession(broker, new Outflow(broker))),
        new ChannelInboundHandlerAdapter() {
          @Override
          public void channelRead(ChannelHandlerContext ctx, Object message) {
            nowMicros += 1_000L * millisecondsPerMessage;
            ctx.fireChannelRead(message);
          }
        });
  }

  private static void send(EmbeddedChannel channel, String topic, int payloadBytes) {
    channel.writeInbound(
        MqttMessageBuilders.publish()
            .topicName(topic)
            .qos(MqttQoS.AT_MOST_ONCE)
            .payload(Unpooled.wrappedBuffer(new byte[payloadBytes]))
            .build());
  }

  @ParameterizedTest
  @CsvSource({
    "u2sa/cessna/goals/GoalList, 1025",
    "u2sa/cessna/grid/OccupancyGrid, 100",
  })
  void channelRead_messagesThatTakeLong_ofAllClientsGetHalfOfTheTime(String topic, int bytes) {
    BrokerState crowded = filter(Map.of());
    EmbeddedChannel flood = clientOf(crowded, 60);
    EmbeddedChannel other = clientOf(crowded, 60);
    for (int i = 0; i < 50; i++) {
      send(flood, topic, bytes);
      send(other, topic, bytes);
    }
    assertThat(letIn(flood)).as("the first overdraws").isEqualTo(1);
    assertThat(letIn(other)).isZero();

    send(other, "u2sa/cessna/state/StateInformation", 100);
    assertThat(letIn(other)).as("a short one in its order").isZero();
    EmbeddedChannel modest = clientOf(crowded, 0);
    send(modest, 10);
    assertThat(letIn(modest)).as("short ones of others").isEqualTo(10);

    long before = nowMicros;
    int taken = 0;
    while (nowMicros - before < 6_000_000) {
      pass(flood, 2);
      pass(other, 2);
      taken += letIn(flood) + letIn(other);
    }
    assertThat(taken).as("60 ms each, in 6 s").isBetween(40, 51);
    for (EmbeddedChannel each : List.of(flood, other, modest)) {
      each.finishAndReleaseAll();
    }
  }

  /** A client that is ready at any time. */
  private record TestGate(boolean isAnonymous) implements Inflow.Gate {
    @Override
    public boolean isReady() {
      return true;
    }

    @Override
    public boolean isInTurn(Object packet) {
      return true;
    }

    @Override
    public boolean isAwaited(Object packet) {
      return packet instanceof MqttPubAckMessage;
    }

    @Override
    public boolean isOperator() {
      return !isAnonymous;
    }
  }

  private void acknowledge(EmbeddedChannel client, int messages) {
    for (int i = 1; i <= messages; i++) {
      client.writeInbound(
          new MqttPubAckMessage(
              new MqttFixedHeader(
                  MqttMessageType.PUBACK, false, MqttQoS.AT_MOST_ONCE, false, Short.BYTES),
              MqttMessageIdVariableHeader.from(i)));
    }
  }

  @Test
  void channelRead_stopBehindHundredsOfAcknowledgements_doesNotWaitThoughASubscriberIsBehind() {
    Inflow bridge = new Inflow(filter, new TestGate(false));
    EmbeddedChannel client = new EmbeddedChannel(bridge);
    bridge.subscriberIsBehind(true);

    acknowledge(client, 1_000);
    send(client, "u2sa/cessna/emergency-stop/EmergencyStop", 50);

    assertThat(letIn(client)).isEqualTo(1_001);
    client.finishAndReleaseAll();
  }

  @Test
  void process_readsOfClientsWithoutALogIn_getATenthOfTheTimeTogether() {
    BrokerState crowded = filter(Map.of());
    Inflow first = new Inflow(crowded, new TestGate(true));
    Inflow second = new Inflow(crowded, new TestGate(true));
    Inflow pilot = new Inflow(crowded, new TestGate(false));
    EmbeddedChannel one = new EmbeddedChannel(first);
    EmbeddedChannel other = new EmbeddedChannel(second);
    EmbeddedChannel operator = new EmbeddedChannel(pilot);

    first.process(() -> nowMicros += 100_000);
    assertThat(one.config().isAutoRead()).isFalse();
    send(other, 1);
    send(operator, 1);
    assertThat(letIn(other)).isZero();
    assertThat(letIn(operator)).isEqualTo(1);
    pass(other, 500);
    assertThat(letIn(other)).isZero();
    pass(other, 500);
    assertThat(letIn(other)).isEqualTo(1);
    for (EmbeddedChannel each : List.of(one, other, operator)) {
      each.finishAndReleaseAll();
    }
  }
}
