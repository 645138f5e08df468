package org.u2sa.benchmarks.mqtt;

import com.hivemq.client.mqtt.MqttClient;
import com.hivemq.client.mqtt.datatypes.MqttQos;
import com.hivemq.client.mqtt.mqtt3.Mqtt3AsyncClient;
import com.hivemq.client.mqtt.mqtt3.Mqtt3ClientBuilder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.u2sa.interfaces.mqtt.LocalToken;

/** HiveMQ's client, its asynchronous interface: bytes out, bytes in. */
final class HiveWay implements Way {
  private final Mqtt3AsyncClient client;
  private final Ways.Load load;

  HiveWay(int port, Ways.Load load, Sink sink) throws IOException {
    this.load = load;
    Mqtt3ClientBuilder builder =
        MqttClient.builder().useMqttVersion3().serverHost("127.0.0.1").serverPort(port);
    Optional<String> token = Token.of(port);
    if (token.isPresent()) {
      builder
          .simpleAuth()
          .username(LocalToken.USER)
          .password(token.get().getBytes(StandardCharsets.UTF_8))
          .applySimpleAuth();
    }
    client = builder.buildAsync();
    client.connect().join();
    if (sink != null) {
      client
          .subscribeWith()
          .topicFilter(PahoWay.TOPIC)
          .qos(MqttQos.fromCode(load.quality()))
          .callback(message -> sink.arrived(Contents.sentNanos(bytes(message.getPayloadAsBytes()))))
          .send()
          .join();
    }
  }

  private static ByteBuffer bytes(byte[] payload) {
    return ByteBuffer.wrap(payload);
  }

  @Override
  public void send(long sentNanos) {
    client
        .publishWith()
        .topic(PahoWay.TOPIC)
        .qos(MqttQos.fromCode(load.quality()))
        .payload(Contents.bytes(load.bytes(), sentNanos))
        .send();
  }

  @Override
  public void close() {
    client.disconnect().join();
  }
}
