package org.u2sa.benchmarks.fleet;

import org.HdrHistogram.Histogram;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/** Hears the states of all vehicles by one connection, and decodes them. */
final class Ground implements Receiver, AutoCloseable {
  private static final long LONGEST_MICROS = 60_000_000;

  private final Histogram latency = new Histogram(LONGEST_MICROS, 3);
  private final Connection connection;
  private long arrived;

  Ground(int port, MessageCodec codec) {
    connection =
        new MqttTransport("127.0.0.1", port, Topic.ANY_SYSTEM, codec).connect("Ground", this);
    if (!connection.subscribe(Channels.STATE)) {
      throw new IllegalStateException("subscription refused");
    }
  }

  @Override
  public synchronized void receive(Channel<?> channel, U2SAData message) {
    long micros = System.nanoTime() / 1_000 - message.timestamp().orElseThrow();
    latency.recordValue(Math.max(0, Math.min(LONGEST_MICROS, micros)));
    arrived++;
  }

  @Override
  public void trouble(String what) {
    System.err.println("ground: " + what);
  }

  /** Forgets what came so far. */
  synchronized void reset() {
    latency.reset();
    arrived = 0;
  }

  synchronized long arrived() {
    return arrived;
  }

  /** Messages that the connection knows it missed, since it was made. */
  long missed() {
    return connection.missed();
  }

  /** From when a message was due to when it was decoded [ms]. */
  synchronized double latencyMs(double percent) {
    return latency.getValueAtPercentile(percent) / 1_000.0;
  }

  @Override
  public void close() {
    connection.close();
  }
}
