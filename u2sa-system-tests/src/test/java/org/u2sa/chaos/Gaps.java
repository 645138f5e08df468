package org.u2sa.chaos;

import java.util.Map;
import java.util.TreeMap;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;

/** How long states, navigation points and commands stay away at most. Safe for all threads. */
final class Gaps implements Receiver, AutoCloseable {
  private final Clock clock;
  private final Connection connection;
  private final Map<String, Long> heardMicros = new TreeMap<>(); // by channel
  private final Map<String, Long> longestMicros = new TreeMap<>(); // likewise

  Gaps(int brokerPort, Clock clock) {
    this.clock = clock;
    MessageCodec codec = new MessageCodec(MessageTypes.discovered());
    connection = new MqttTransport("127.0.0.1", brokerPort, "cessna", codec).connect("Gaps", this);
    connection.subscribe(Channels.STATE);
    connection.subscribe(Channels.NAVIGATION);
    connection.subscribe(Channels.ACTUATION);
  }

  @Override
  public synchronized void receive(Channel<?> channel, U2SAData message) {
    long now = clock.micros();
    Long before = heardMicros.put(channel.name(), now);
    if (before != null) {
      longestMicros.merge(channel.name(), now - before, Math::max);
    }
  }

  /** Begins again. */
  synchronized void forget() {
    longestMicros.clear();
  }

  /** The longest time between two messages of the channel that came since then [s]. */
  synchronized double longestS(Channel<?> channel) {
    return Clock.seconds(longestMicros.getOrDefault(channel.name(), 0L));
  }

  @Override
  public void trouble(String what) {
    // a broken connection shows as a gap
  }

  @Override
  public void close() {
    connection.close();
  }
}
