package org.u2sa.interfaces.mqtt;

import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/**
 * Delivers messages from an MQTT connection to its receiver, and counts failures in both
 * directions.
 */
final class IncomingMessages {
  private final MessageCodec codec;
  private final Receiver receiver;
  private final AtomicLong refused = new AtomicLong();
  private final Gaps gaps = new Gaps();

  IncomingMessages(MessageCodec codec, Receiver receiver) {
    this.codec = codec;
    this.receiver = receiver;
  }

  void hand(Channel<?> channel, Topic topic, byte[] payload) {
    try {
      U2SAData data = codec.decode(topic.typeChain(), payload);
      data.freeze();
      long gap = gaps.arrived(topic.toString(), data.origin());
      noteGap(topic, gap);
      if (gap == Gaps.REPEATED && isState(channel)) {
        return;
      }
      if (channel.carries(data)) {
        receiver.receive(channel, data);
      } else {
        refuse("a message on " + topic + " is not of type " + channel.type().name());
      }
    } catch (MalformedMessageException | IllegalArgumentException e) {
      refuse("a message on " + topic + " cannot be read: " + e.getMessage());
    } catch (RuntimeException e) { // an exception would end the session
      refuse("receiving a message on " + topic + " failed: " + e);
    }
  }

  /**
   * Whether each message of the channel supersedes all earlier ones: a broker may deliver old ones
   * again after a reconnection. A stop always counts.
   */
  private static boolean isState(Channel<?> channel) {
    return channel.isRetained() && !channel.equals(Channels.EMERGENCY_STOP);
  }

  private void noteGap(Topic topic, long gap) {
    long missed = gaps.missed();
    if (gap > 0
        && Long.highestOneBit(missed) > missed - gap) { // log at 1, 2, 4, 8…, to avoid a flood
      receiver.trouble(gap + " messages on " + topic + " were missed (" + missed + " so far)");
    }
  }

  /** Messages sent until the channel is subscribed again do not count as missed. */
  void forget(Channel<?> channel) {
    gaps.forget(topic -> Topic.parse(topic).channel().equals(channel.name()));
  }

  long missed() {
    return gaps.missed();
  }

  /** Counts a failed message, logging the reason occasionally. */
  void refuse(String why) {
    long count = refused.incrementAndGet();
    if (Long.bitCount(count) == 1) { // log at 1, 2, 4, 8…, to avoid a flood
      receiver.trouble(why + " (" + count + " so far)");
    }
  }

  /** Counts failed messages that are reported elsewhere. */
  void refuse(long messages) {
    refused.addAndGet(messages);
  }

  long refused() {
    return refused.get();
  }
}
