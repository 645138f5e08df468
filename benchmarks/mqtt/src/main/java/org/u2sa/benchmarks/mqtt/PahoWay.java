package org.u2sa.benchmarks.mqtt;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.UUID;
import org.eclipse.paho.client.mqttv3.IMqttDeliveryToken;
import org.eclipse.paho.client.mqttv3.MqttAsyncClient;
import org.eclipse.paho.client.mqttv3.MqttCallback;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.eclipse.paho.client.mqttv3.MqttMessage;
import org.eclipse.paho.client.mqttv3.persist.MemoryPersistence;
import org.u2sa.interfaces.mqtt.LocalToken;

/** Plain Paho as one would write it: bytes out, bytes in. */
final class PahoWay implements Way {
  static final String TOPIC = "u2sa/" + Contents.SYSTEM + "/benchmark-bytes/StateInformation";
  private static final int IN_FLIGHT = 10_000;

  private final MqttAsyncClient client;
  private final Ways.Load load;

  PahoWay(int port, Ways.Load load, Sink sink) throws MqttException, IOException {
    this.load = load;
    client =
        new MqttAsyncClient(
            "tcp://127.0.0.1:" + port, "paho-" + UUID.randomUUID(), new MemoryPersistence());
    MqttConnectOptions options = new MqttConnectOptions();
    options.setMaxInflight(IN_FLIGHT);
    Token.of(port)
        .ifPresent(
            token -> {
              options.setUserName(LocalToken.USER);
              options.setPassword(token.toCharArray());
            });
    if (sink != null) {
      client.setCallback(new ToSink(sink));
    }
    client.connect(options).waitForCompletion();
    if (sink != null) {
      client.subscribe(TOPIC, load.quality()).waitForCompletion();
    }
  }

  @Override
  public void send(long sentNanos) throws Exception {
    while (true) {
      try {
        client.publish(TOPIC, Contents.bytes(load.bytes(), sentNanos), load.quality(), false);
        return;
      } catch (MqttException e) {
        if (e.getReasonCode() != MqttException.REASON_CODE_MAX_INFLIGHT
            && e.getReasonCode() != MqttException.REASON_CODE_NO_MESSAGE_IDS_AVAILABLE) {
          throw e;
        }
        Thread.sleep(1);
      }
    }
  }

  @Override
  public void close() throws MqttException {
    client.disconnect().waitForCompletion();
    client.close();
  }

  private record ToSink(Sink sink) implements MqttCallback {
    @Override
    public void messageArrived(String topic, MqttMessage message) {
      sink.arrived(Contents.sentNanos(ByteBuffer.wrap(message.getPayload())));
    }

    @Override
    public void connectionLost(Throwable cause) {
      System.err.println("paho: " + cause);
    }

    @Override
    public void deliveryComplete(IMqttDeliveryToken token) {
      // what arrives is counted where it arrives
    }
  }
}
