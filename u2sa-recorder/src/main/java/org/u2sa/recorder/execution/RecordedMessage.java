package org.u2sa.recorder.execution;

import java.util.Arrays;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.schema.MalformedMessageException;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.mcap.McapException;

/** A message of a recording, which is decoded only where its fields are wanted. */
final class RecordedMessage {
  private final MessageCodec codec;
  private final Track track;
  private final byte[] data;

  /** The messages of a topic. */
  record Track(Topic topic, Channel<?> channel) {}

  /**
   * A message as a service handled it.
   *
   * @param arrivedMicros when it came, where the service wanted to know; otherwise 0 [µs]
   */
  record Handled(Channel<?> channel, U2SAData message, long arrivedMicros) {}

  RecordedMessage(MessageCodec codec, Track track, byte[] data) {
    this.codec = codec;
    this.track = track;
    this.data = data;
  }

  Channel<?> channel() {
    return track.channel;
  }

  /** Whether a message is this one, to the byte, its type included. */
  boolean is(U2SAData other) {
    return Arrays.equals(data, other.serialize())
        && track.topic.typeChain().equals(other.typeChain());
  }

  /**
   * The message, frozen.
   *
   * @throws McapException if its bytes are none
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
