package org.u2sa.core.communication;

import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Gaps;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.schema.MalformedMessageException;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/** What remote clients publish, on its way to the bus. Counts what cannot be read or was lost. */
final class IncomingCopies {
  private final LocalBus bus;
  private final MessageCodec codec;
  private final Consumer<String> log;
  private final Gaps gaps = new Gaps();
  private final AtomicLong unreadable = new AtomicLong();

  IncomingCopies(LocalBus bus, MessageCodec codec, Consumer<String> log) {
    this.bus = bus;
    this.codec = codec;
    this.log = log;
  }

  /** Hands a packet's message to the services of this process; of another vehicle, to nobody. */
  void deliver(String topicName, byte[] payload) {
    try {
      Topic topic = Topic.parse(topicName);
      if (topic.systemId().equals(bus.systemId())) {
        deliver(topic, topicName, payload);
      }
    } catch (MalformedMessageException | IllegalArgumentException e) {
      long count = unreadable.incrementAndGet();
      if (Long.bitCount(count) == 1) { // 1, 2, 4, 8…: a flood does not fill the log
        log.accept(
            "a message on "
                + Refusals.shown(topicName)
                + " cannot be read: "
                + Refusals.shown(String.valueOf(e.getMessage()))
                + " ("
                + count
                + " so far)");
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
          "it is not of the channel's type " + channel.type().name());
    }
    long missed = gaps.arrived(topicName, message.origin());
    if (missed > 0) {
      bus.missed(channel, missed);
    }
    bus.deliver(channel, message);
  }
}
