package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.embedded.EmbeddedChannel;
import io.netty.handler.codec.mqtt.MqttEncoder;
import io.netty.handler.codec.mqtt.MqttMessageBuilders;
import io.netty.handler.codec.mqtt.MqttQoS;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;

/** Who counts as too slow to be served. */
class OutflowTest {
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

  @Test
  void tooSlow_clientThatReadsAll_never() {
    BrokerLimits limits =
        XmlConfiguration.inMemory("test", Map.of()).settings(BrokerLimits.class).get();
    MessageCodec codec = new MessageCodec(StandardTypes.registry());
    BrokerState filter = new BrokerState(limits, codec, new TestClock(), null, line -> {});
    Outflow outflow = new Outflow(filter);
    EmbeddedChannel channel = new EmbeddedChannel(MqttEncoder.INSTANCE, outflow);
    ChannelHandlerContext context = channel.pipeline().context(outflow);

    for (int second = 0; second < 60; second++) {
      nowMicros += 1_000_000;
      channel.writeOutbound(
          MqttMessageBuilders.publish()
              .topicName("u2sa/cessna/health/HealthReport")
              .qos(MqttQoS.AT_MOST_ONCE)
              .payload(Unpooled.wrappedBuffer(new byte[100]))
              .build());

      assertThat(outflow.tooSlow(context)).as("after %d s", second).isEmpty();
    }
    channel.finishAndReleaseAll();
  }
}
