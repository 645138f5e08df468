package org.u2sa.recorder.execution;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import org.u2sa.recorder.mcap.record.McapMessage;

/** Cache of the recorded messages read last, by channel and sequence number. Not thread-safe. */
final class RecentlyRead {
  private final int maxMessages;
  private final long maxBytes;
  private final Map<Long, McapMessage> messages = new HashMap<>();
  private final Deque<Long> inOrder = new ArrayDeque<>();
  private long bytes;

  /** Limits the number of messages and their payload, without object overhead [B]. */
  RecentlyRead(int maxMessages, long maxBytes) {
    this.maxMessages = maxMessages;
    this.maxBytes = maxBytes;
  }

  /** Adds a message and evicts the oldest ones beyond the count or size limit. */
  void add(McapMessage message) {
    long key = key(message.channelId(), message.sequence());
    bytes += message.data().length - length(messages.put(key, message));
    inOrder.add(key);
    while (inOrder.size() > maxMessages || bytes > maxBytes) {
      bytes -= length(messages.remove(inOrder.remove()));
    }
  }

  private static long length(McapMessage message) {
    return message == null ? 0 : message.data().length; // null if the number was a duplicate
  }

  /** Message with this number; null if not cached. */
  McapMessage message(long channelId, long sequence) {
    return messages.get(key(channelId, sequence));
  }

  private static long key(long channelId, long sequence) {
    return channelId << Integer.SIZE | sequence;
  }
}
