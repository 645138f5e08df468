package org.u2sa.interfaces.mqtt;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.u2sa.messages.schema.Origin;

/**
 * Counts messages lost over MQTT from gaps in a sender's sequence numbers per topic. Messages sent
 * before the first one received do not count. Thread-safe.
 */
public final class Gaps {
  /** Result of {@link #arrived} for a repetition, or a message older than the newest received. */
  public static final long REPEATED = -1L;

  /** Senders and topics remembered; a gap of a forgotten one is not detected. */
  private static final int REMEMBERED = 4_096;

  private record Stream(String sender, String topic) {}

  private final Map<Stream, Long> last =
      new LinkedHashMap<>(64, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Stream, Long> eldest) {
          return size() > REMEMBERED;
        }
      };
  private long missed;

  /**
   * Returns the number of messages missing immediately before this one; 0 without an origin, {@link
   * #REPEATED} if its number is not above the last one of its sender and topic.
   */
  public synchronized long arrived(String topic, Optional<Origin> origin) {
    if (!origin.isPresent()) {
      return 0;
    }
    Stream stream = new Stream(origin.get().sender(), topic);
    long sequence = origin.get().sequence();
    Long before = last.get(stream);
    if (before != null && sequence <= before) {
      return REPEATED; // or retained by the broker
    }
    last.put(stream, sequence);
    long gap = before == null ? 0 : sequence - before - 1;
    missed = gap > Long.MAX_VALUE - missed ? Long.MAX_VALUE : missed + gap; // senders choose it
    return gap;
  }

  /** The next message on such a topic is treated as the first. */
  public synchronized void forget(Predicate<String> topics) {
    last.keySet().removeIf(stream -> topics.test(stream.topic()));
  }

  /** Messages missed since the start, at most {@link Long#MAX_VALUE}. */
  public synchronized long missed() {
    return missed;
  }
}
