package org.u2sa.recorder.execution;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.UnaryOperator;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.schema.U2SAData;

/**
 * Compares a service's output with its recorded output. Health reports are ignored, since they
 * contain callback durations on the machine.
 */
final class OutputComparison implements RecordedCourse.Outputs {
  private final UnaryOperator<String> asRecorded;
  private final Map<String, ChannelComparison> channels = new TreeMap<>();

  /**
   * @param asRecorded replaces the re-execution's temporary paths in a text
   */
  OutputComparison(UnaryOperator<String> asRecorded) {
    this.asRecorded = asRecorded;
  }

  @Override
  public void published(long micros, Channel<?> channel, RecordedMessage recorded, U2SAData now)
      throws IOException {
    if (!channel.equals(Channels.HEALTH)) {
      channels
          .computeIfAbsent(channel.name(), name -> new ChannelComparison(channel, asRecorded))
          .add(micros, recorded, now);
    }
  }

  /** All channels with output, by name. */
  List<ChannelComparison> channels() {
    return new ArrayList<>(channels.values());
  }
}
