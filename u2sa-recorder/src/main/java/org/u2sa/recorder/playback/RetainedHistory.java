package org.u2sa.recorder.playback;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.recorder.mcap.McapCursor;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;

/**
 * The retained messages of a recording, so that a playback that begins in the middle can give what
 * a late subscriber would have received there. Immutable.
 */
public final class RetainedHistory {
  private static final int MAX_MESSAGES = 100_000; // retained messages are changes, not samples

  private final List<TreeMap<Long, McapMessage>> byTopic = new ArrayList<>();

  /** Reads the retained messages, to at most the first 100,000. */
  public RetainedHistory(RecordedMessages recording) throws IOException {
    TreeMap<Integer, TreeMap<Long, McapMessage>> histories = new TreeMap<>();
    McapCursor cursor =
        recording.reader().messages(Long.MIN_VALUE, channel -> isRetained(recording, channel));
    int count = 0;
    for (Optional<McapMessage> m = cursor.next();
        m.isPresent() && count < MAX_MESSAGES;
        m = cursor.next()) {
      histories
          .computeIfAbsent(m.get().channelId(), id -> new TreeMap<>())
          .put(m.get().logTimeNanos(), m.get());
      count++;
    }
    byTopic.addAll(histories.values());
  }

  private static boolean isRetained(RecordedMessages recording, McapChannel channel) {
    return recording
        .topic(channel)
        .filter(topic -> Channels.namedOrNew(topic.channel()).isRetained())
        .isPresent();
  }

  /** The newest retained message of each topic before a log time [ns]. */
  public List<McapMessage> before(long nanos) {
    List<McapMessage> messages = new ArrayList<>();
    for (TreeMap<Long, McapMessage> history : byTopic) {
      Optional.ofNullable(history.lowerEntry(nanos))
          .ifPresent(each -> messages.add(each.getValue()));
    }
    return messages;
  }
}
