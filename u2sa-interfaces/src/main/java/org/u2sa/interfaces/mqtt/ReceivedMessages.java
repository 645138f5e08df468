package org.u2sa.interfaces.mqtt;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;

/**
 * Last message received on each retained topic. Bounded, because clients can create arbitrary
 * topics; evicted messages are delivered again after a reconnection. Thread-safe.
 */
final class ReceivedMessages {
  private static final int MAX_TOPICS = 4_096;
  private static final long MAX_BYTES = Math.max(2L << 20, Runtime.getRuntime().maxMemory() / 64);

  private final Map<String, byte[]> last = new LinkedHashMap<>(16, 0.75f, true);
  private long bytes;

  /** Records a message; returns the previous message on its topic, or null. */
  synchronized byte[] put(String topic, byte[] payload) {
    byte[] before = last.put(topic, payload);
    bytes += payload.length - (before == null ? 0 : before.length);
    while (last.size() > MAX_TOPICS || bytes > MAX_BYTES && last.size() > 1) {
      String eldest = last.keySet().iterator().next();
      bytes -= last.remove(eldest).length;
    }
    return before;
  }

  synchronized List<String> topics() {
    return List.copyOf(last.keySet());
  }

  synchronized void forget(Predicate<String> topics) {
    last.keySet().removeIf(topics);
    bytes = last.values().stream().mapToLong(payload -> payload.length).sum();
  }
}
