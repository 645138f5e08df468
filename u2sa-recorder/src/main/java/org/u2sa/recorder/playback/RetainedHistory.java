package org.u2sa.recorder.playback;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.recorder.mcap.McapCursor;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;

/**
 * The retained messages of a recording, so that a playback that starts in the middle can deliver
 * what a late subscriber would have received there. Stores only their times, because maps may be
 * large. Immutable.
 */
public final class RetainedHistory {
  private static final int MAX_MESSAGES = 4_000_000; // 32 MB

  /** Log times of a topic, ascending [ns]. */
  private static final class Times {
    private long[] nanos = new long[16];
    private int count;

    void add(long time) {
      nanos = count < nanos.length ? nanos : Arrays.copyOf(nanos, 2 * count);
      nanos[count++] = time;
    }

    /** The newest one before a time. */
    Optional<Long> before(long time) {
      int found = Arrays.binarySearch(nanos, 0, count, time);
      int index = found < 0 ? -found - 1 : found;
      while (index > 0 && nanos[index - 1] == time) {
        index--; // binary search may hit any of several equal times
      }
      return index == 0 ? Optional.empty() : Optional.of(nanos[index - 1]);
    }
  }

  private final RecordedMessages recording;
  private final TreeMap<Integer, Times> byTopic = new TreeMap<>(); // by channel ID

  /** Reads the times of the retained messages, up to the first four million. */
  public RetainedHistory(RecordedMessages recording) throws IOException {
    this.recording = recording;
    McapCursor cursor =
        recording.reader().messages(Long.MIN_VALUE, channel -> isRetained(recording, channel));
    int count = 0;
    for (Optional<McapMessage> m = cursor.next();
        m.isPresent() && count < MAX_MESSAGES;
        m = cursor.next()) {
      byTopic.computeIfAbsent(m.get().channelId(), id -> new Times()).add(m.get().logTimeNanos());
      count++;
    }
  }

  private static boolean isRetained(RecordedMessages recording, McapChannel channel) {
    return recording
        .topic(channel)
        .filter(topic -> Channels.namedOrNew(topic.channel()).isRetained())
        .isPresent();
  }

  /** The newest retained message of each topic before a log time [ns]. */
  public List<McapMessage> before(long nanos) throws IOException {
    List<McapMessage> messages = new ArrayList<>();
    for (int id : byTopic.keySet()) {
      Optional<Long> time = byTopic.get(id).before(nanos);
      if (time.isPresent()) {
        read(id, time.get()).ifPresent(messages::add);
      }
    }
    return messages;
  }

  /** The last message of a channel with that log time. */
  private Optional<McapMessage> read(int id, long nanos) throws IOException {
    McapCursor cursor = recording.reader().messages(nanos, channel -> channel.id() == id);
    Optional<McapMessage> last = Optional.empty();
    for (Optional<McapMessage> m = cursor.next();
        m.isPresent() && m.get().logTimeNanos() == nanos;
        m = cursor.next()) {
      last = m;
    }
    return last;
  }
}
