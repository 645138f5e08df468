package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.frozen;

import java.io.IOException;
import java.util.HexFormat;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.cbor.WireForm;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;

/** MQTT through the embedded broker, all fields named by their labels. */
class EmbeddedBrokerCompactFormContractTest extends TransportContract {
  private static final String SYSTEM_ID = "0066636573736e61"; // 0: "cessna"

  private final TestManager broker = new TestManager(Map.of("WIRE FORM", "compact"));

  @Override
  Transport transport() {
    MessageCodec codec = new MessageCodec(StandardTypes.registry(), WireForm.COMPACT);
    return new MqttTransport("127.0.0.1", broker.port, "cessna", codec)
        .waiting(TestManager.PATIENCE_S);
  }

  @Override
  void close() {
    broker.close();
  }

  @Test
  @Timeout(60)
  void publish_byAServiceWithinAndOneWithout_hasLabelsOnTheWire() throws IOException {
    Connection within = broker.local("Within", new RecordingReceiver());
    Connection without = broker.keep(transport().connect("Without", new RecordingReceiver()));
    try (RawClient reader = new RawClient(broker.port).introduced("reader")) {
      reader.subscribe("u2sa/cessna/" + Channels.GOALS.name() + "/#");
      reader.subscribe("u2sa/cessna/" + Channels.OBJECTS.name() + "/#");

      assertThat(within.publish(Channels.GOALS, frozen(new GoalList()))).isTrue();
      assertThat(next(reader)).contains(SYSTEM_ID);

      assertThat(without.publish(Channels.OBJECTS, frozen(new ObjectList()))).isTrue();
      assertThat(next(reader)).contains(SYSTEM_ID);
    }
  }

  private static String next(RawClient reader) throws IOException {
    reader.next();
    return HexFormat.of().formatHex(reader.content());
  }
}
