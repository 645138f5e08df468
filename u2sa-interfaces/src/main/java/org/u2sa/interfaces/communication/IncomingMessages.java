package org.u2sa.interfaces.communication;

import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.messages.schema.MalformedMessageException;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/**
 * The way of messages from an MQTT connection to its receiver, and the count of those that did not
 * get through in either direction.
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

  /** Reads one message and hands it over. */
  void hand(Channel<?> channel, Topic topic, byte[] payload) {
    try {
      U2SAData data = codec.decode(topic.typeChain(), payload);
      data.freeze();
      noteGap(topic, gaps.arrived(topic.toString(), data.origin()));
      if (channel.carries(data)) {
        receiver.receive(channel, data);
      } else {
        refuse("a message on " + topic + " is not of type " + channel.type().name());
      }
    } catch (MalformedMessageException | IllegalArgumentException e) {
      refuse("a message on " + topic + " cannot be read: " + e.getMessage());
    } catch (RuntimeException e) { // the session would end
      refuse("receiving a message on " + topic + " failed: " + e);
    }
  }

  private void noteGap(Topic topic, long gap) {
    long missed = gaps.missed();
    if (gap > 0 && Long.highestOneBit(missed) > missed - gap) { // past 1, 2, 4, 8…: no flood
      receiver.trouble(gap + " messages on " + topic + " were missed (" + missed + " so far)");
    }
  }

  /**
   * Forgets what came on a channel: what others send until it is subscribed again is not missed.
   */
  void forget(Channel<?> channel) {
    gaps.forget(topic -> Topic.parse(topic).channel().equals(channel.name()));
  }

  long missed() {
    return gaps.missed();
  }

  /** Counts a message that did not get through, and tells why, now and then. */
  void refuse(String why) {
    long count = refused.incrementAndGet();
    if (Long.bitCount(count) == 1) { // 1, 2, 4, 8…: a flood does not fill the log
      receiver.trouble(why + " (" + count + " so far)");
    }
  }

  /** Counts messages whose fate is told elsewhere. */
  void refuse(long messages) {
    refused.addAndGet(messages);
  }

  long refused() {
    return refused.get();
  }
}
