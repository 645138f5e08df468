package org.u2sa.recorder.execution;

import java.util.List;
import java.util.function.Function;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.schema.U2SAData;

/**
 * A part of an execution, written as one message of a recording.
 *
 * @param execution name of the execution
 * @param number sequence number of the part, from 0; a gap reveals a loss
 * @param micros time it was closed [µs of the run's clock]
 * @param entries packed entries, in order; see {@link ExecutionEntry}
 * @param messages the entries' messages, in order
 */
public record ExecutionPart(
    String execution, long number, long micros, byte[] entries, List<Passed> messages) {
  /** Message encoding of MCAP channels with executions. */
  public static final String ENCODING = "u2sa-execution";

  /** Topic prefix of these channels. */
  public static final String TOPIC = "execution/";

  /** Maximum distance of a referenced message, in messages back in the file. */
  public static final int REACH = 8192;

  /** Channel number of a message whose bytes are stored inline. */
  static final int HERE = 0;

  /** A message received or published. */
  public record Passed(Channel<?> channel, U2SAData message) {}

  /** Position of a message in the same recording: MCAP channel and sequence number. */
  public record Place(int channelId, long sequence) {}

  /**
   * Encodes the part.
   *
   * @param systemId system ID of messages that have none
   * @param places positions of recently recorded messages; returns null for others, which are then
   *     stored inline
   */
  public byte[] bytes(String systemId, Function<U2SAData, Place> places) {
    PackedWriter out = new PackedWriter().number(number).bytes(entries);
    for (Passed passed : messages) {
      Place place = places.apply(passed.message);
      if (place != null) {
        out.number(place.channelId).number(place.sequence);
      } else {
        String system = passed.message.systemId();
        out.number(HERE)
            .text(
                Topic.of(system.isEmpty() ? systemId : system, passed.channel, passed.message)
                    .toString())
            .bytes(passed.message.serialize());
      }
    }
    return out.toBytes();
  }
}
