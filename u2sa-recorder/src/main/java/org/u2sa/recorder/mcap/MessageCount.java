package org.u2sa.recorder.mcap;

import java.util.Map;
import java.util.TreeMap;

/** Counts messages, and the span of their log times. */
final class MessageCount {
  private final Map<Integer, long[]> byChannel = new TreeMap<>();
  private long messages;
  private long startNanos;
  private long endNanos;

  void add(int channelId, long logTimeNanos) {
    byChannel.computeIfAbsent(channelId, id -> new long[1])[0]++;
    startNanos = messages == 0 ? logTimeNanos : Math.min(startNanos, logTimeNanos);
    endNanos = messages == 0 ? logTimeNanos : Math.max(endNanos, logTimeNanos);
    messages++;
  }

  void add(MessageCount other) {
    if (other.messages > 0) {
      startNanos = messages == 0 ? other.startNanos : Math.min(startNanos, other.startNanos);
      endNanos = messages == 0 ? other.endNanos : Math.max(endNanos, other.endNanos);
      messages += other.messages;
      other.byChannel.forEach(
          (id, count) -> byChannel.computeIfAbsent(id, key -> new long[1])[0] += count[0]);
    }
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
    byChannel.forEach((id, count) -> counts.put(id, count[0]));
    return counts;
  }
}
