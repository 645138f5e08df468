package org.u2sa.benchmarks.mqtt;

import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/** Our MQTT from connection to connection: encoded, sent, decoded, handed to the receiver. */
final class U2saWay implements Way {
  private final Channel<StateInformation> channel;
  private final String filling;
  private final Connection connection;

  U2saWay(int port, Ways.Load load, Sink sink) {
    channel = Contents.channel(load.quality());
    filling = Contents.filling(load.bytes());
    connection =
        transport(port).connect(sink == null ? "Source" : "Sink", new ToSink(sink));
    if (sink != null && !connection.subscribe(channel)) {
      throw new IllegalStateException("subscription refused");
    }
  }

  static MqttTransport transport(int port) {
    return new MqttTransport(
        "127.0.0.1", port, Contents.SYSTEM, new MessageCodec(StandardTypes.registry()));
  }

  @Override
  public void send(long sentNanos) throws InterruptedException {
    while (!connection.publish(channel, Contents.frozen(filling, sentNanos))) {
      Thread.sleep(1); // it owes too many
    }
  }

  @Override
  public void close() {
    connection.close();
  }

  private record ToSink(Sink sink) implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      sink.arrived(Contents.sentNanos((StateInformation) message));
    }

    @Override
    public void trouble(String what) {
      System.err.println(what);
    }
  }
}
