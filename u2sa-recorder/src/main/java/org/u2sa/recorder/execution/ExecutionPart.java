package org.u2sa.recorder.execution;

import java.util.List;
import java.util.function.Function;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.schema.U2SAData;

/**
 * A piece of an execution, to be written as one message of a recording.
 *
 * @param execution which execution
 * @param number of the part, from 0: a gap shows that one was lost
 * @param micros when it was closed [µs of the run's clock]
 * @param entries what passed, in order; see {@link ExecutionEntry}
 * @param messages those that the entries are about, in turn
 */
public record ExecutionPart(
    String execution, long number, long micros, byte[] entries, List<Passed> messages) {
  /** Encoding of the MCAP channels that hold executions. */
  public static final String ENCODING = "u2sa-execution";

  /** What topics of such channels begin with. */
  public static final String TOPIC = "execution/";

  /** Messages of a file back to which a part may refer. */
  public static final int REACH = 8192;

  /** Of a message whose bytes stand here, the number of the channel. */
  static final int HERE = 0;

  /** A message that came or went. */
  public record Passed(Channel<?> channel, U2SAData message) {}

  /** Where a message is in the same recording: its MCAP channel and its sequence there. */
  public record Place(int channelId, long sequence) {}

  /**
   * The bytes for the recording.
   *
   * @param systemId of messages that name none
   * @param places where messages are that were recorded not long ago; null: not among them, and
   *     written once more here
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
