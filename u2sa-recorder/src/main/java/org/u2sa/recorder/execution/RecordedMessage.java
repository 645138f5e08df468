package org.u2sa.recorder.execution;

import java.util.Arrays;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.mcap.record.McapException;

/** A recorded message, decoded lazily. */
final class RecordedMessage {
  private final MessageCodec codec;
  private final Track track;
  private final byte[] data;

  record Track(Topic topic, Channel<?> channel) {}

  /** A message handled by a service, and when it arrived [µs]; 0 if the service did not ask. */
  record Handled(Channel<?> channel, U2SAData message, long arrivedMicros) {}

  RecordedMessage(MessageCodec codec, Track track, byte[] data) {
    this.codec = codec;
    this.track = track;
    this.data = data;
  }

  Channel<?> channel() {
    return track.channel;
  }

  /** Whether a message has the same type and is byte-identical. */
  boolean is(U2SAData other) {
    return Arrays.equals(data, other.serialize())
        && track.topic.typeChain().equals(other.typeChain());
  }

  /**
   * Decoded message, frozen.
   *
   * @throws McapException if the bytes are not a message
   */
  U2SAData decoded() throws McapException {
    try {
      U2SAData message = codec.decode(track.topic.typeChain(), data);
      message.freeze();
      return message;
    } catch (MalformedMessageException | IllegalStateException e) {
      throw new McapException("a message on " + track.topic + ": " + e.getMessage(), e);
    }
  }
}
