package org.u2sa.recorder.mcap;

import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;

/** Message counts and log-time range. */
final class MessageCount {
  private static final int FIRST_CHANNELS = 64;

  private long[] byChannel = new long[FIRST_CHANNELS];
  private long messages;
  private long startNanos;
  private long endNanos;

  void add(int channelId, long logTimeNanos) {
    count(channelId, 1L);
    add(1L, logTimeNanos, logTimeNanos);
  }

  void add(MessageCount other) {
    if (other.messages > 0) {
      add(other.messages, other.startNanos, other.endNanos);
      for (int id = other.byChannel.length - 1; id >= 0; id--) {
        if (other.byChannel[id] > 0) {
          count(id, other.byChannel[id]);
        }
      }
    }
  }

  private void count(int channelId, long more) {
    if (channelId >= byChannel.length) {
      byChannel = Arrays.copyOf(byChannel, Math.max(2 * byChannel.length, channelId + 1));
    }
    byChannel[channelId] += more;
  }

  private void add(long more, long fromNanos, long toNanos) {
    startNanos = messages == 0 ? fromNanos : Math.min(startNanos, fromNanos);
    endNanos = messages == 0 ? toNanos : Math.max(endNanos, toNanos);
    messages += more;
  }

  long messages() {
    return messages;
  }

  long startNanos() {
    return startNanos;
  }

  long endNanos() {
    return endNanos;
  }

  Map<Integer, Long> byChannel() {
    Map<Integer, Long> counts = new TreeMap<>();
    for (int id = 0; id < byChannel.length; id++) {
      if (byChannel[id] > 0) {
        counts.put(id, byChannel[id]);
      }
    }
    return counts;
  }

  void clear() {
    Arrays.fill(byChannel, 0L);
    messages = 0;
    startNanos = 0;
    endNanos = 0;
  }
}
