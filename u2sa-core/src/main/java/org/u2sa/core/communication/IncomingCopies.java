package org.u2sa.core.communication;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.ByteBufUtil;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.u2sa.core.communication.access.Refusals;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.mqtt.Gaps;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/** Puts messages of remote clients on the bus. Counts undecodable and lost messages. */
final class IncomingCopies implements MessageRouter.Reader {
  private static final int TOPICS_REMEMBERED = 1_024;

  /**
   * Meaning of a topic to this process.
   *
   * @param isOurs whether it belongs to this process's system
   * @param isKept whether the bus keeps the last message for late subscribers
   */
  private record Source(Topic topic, boolean isOurs, boolean isKept) {}

  private final LocalBus bus;
  private final MessageCodec codec;
  private final Consumer<String> log;
  private final Gaps gaps = new Gaps();
  private final AtomicLong unreadable = new AtomicLong();
  private final Map<String, Source> sources = new ConcurrentHashMap<>(); // by topic
  private final Set<String> heard = ConcurrentHashMap.newKeySet(); // topics tracked in gaps

  IncomingCopies(LocalBus bus, MessageCodec codec, Consumer<String> log) {
    this.bus = bus;
    this.codec = codec;
    this.log = log;
  }

  @Override
  public boolean wants(String topicName) {
    Source source = sources.get(topicName);
    if (source == null) {
      return true; // decided when the message is read
    }
    boolean wanted = source.isOurs && (source.isKept || bus.isHeard(source.topic.channel()));
    if (!wanted && heard.remove(topicName)) {
      gaps.forget(topicName::equals); // messages in between do not count as lost
    }
    return wanted;
  }

  @Override
  public void read(String topic, ByteBuf payload) {
    deliver(topic, ByteBufUtil.getBytes(payload));
  }

  private Source source(String topicName) {
    Source known = sources.get(topicName);
    if (known == null) {
      Topic topic = Topic.parse(topicName);
      boolean isKept = Channels.named(topic.channel()).filter(Channel::isRetained).isPresent();
      known = new Source(topic, topic.systemId().equals(bus.systemId()), isKept);
      if (sources.size() < TOPICS_REMEMBERED) {
        sources.put(topicName, known);
      }
    }
    return known;
  }

  /** Delivers a packet's message to the services of this process; ignores other vehicles. */
  void deliver(String topicName, byte[] payload) {
    try {
      Source source = source(topicName);
      if (source.isOurs) {
        deliver(source.topic, topicName, payload);
      }
    } catch (MalformedMessageException | IllegalArgumentException e) {
      long count = unreadable.incrementAndGet();
      if (Long.bitCount(count) == 1) { // log the 1st, 2nd, 4th, 8th… to bound the log
        log.accept(
            String.format(
                "a message on %s cannot be read: %s (%s so far)",
                Refusals.shown(topicName), Refusals.shown(String.valueOf(e.getMessage())), count));
      }
    }
  }

  private void deliver(Topic topic, String topicName, byte[] payload)
      throws MalformedMessageException {
    Channel<? extends U2SAData> channel = Channels.namedOrNew(topic.channel());
    U2SAData message = codec.decode(topic.typeChain(), payload);
    message.freeze();
    if (!channel.carries(message)) {
      throw new IllegalArgumentException(
          "its type does not match the channel: " + channel.type().name());
    }
    if (heard.size() < TOPICS_REMEMBERED) {
      heard.add(topicName);
    }
    long missed = gaps.arrived(topicName, message.origin());
    if (missed > 0) {
      bus.missed(channel, missed);
    }
    bus.deliver(channel, message);
  }
}
