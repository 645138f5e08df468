package org.u2sa.recorder.execution;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import org.u2sa.recorder.mcap.McapMessage;

/**
 * The messages of a recording that were read last, by channel and sequence number. Belongs to one
 * thread.
 */
final class RecentlyRead {
  private final int maxMessages;
  private final long maxBytes;
  private final Map<Long, McapMessage> messages = new HashMap<>();
  private final Deque<Long> inOrder = new ArrayDeque<>();
  private long bytes;

  /**
   * @param maxBytes of all messages, without what Java needs for each [B]
   */
  RecentlyRead(int maxMessages, long maxBytes) {
    this.maxMessages = maxMessages;
    this.maxBytes = maxBytes;
  }

  /**
   * Adds the next message, and forgets the oldest ones where there are too many or too long ones.
   */
  void add(McapMessage message) {
    long key = key(message.channelId(), message.sequence());
    bytes += message.data().length - length(messages.put(key, message));
    inOrder.add(key);
    while (inOrder.size() > maxMessages || bytes > maxBytes) {
      bytes -= length(messages.remove(inOrder.remove()));
    }
  }

  private static long length(McapMessage message) {
    return message == null ? 0 : message.data().length; // a number that came twice
  }

  /** The message of that number; null if it is not among them. */
  McapMessage message(long channelId, long sequence) {
    return messages.get(key(channelId, sequence));
  }

  private static long key(long channelId, long sequence) {
    return channelId << Integer.SIZE | sequence;
  }
}
