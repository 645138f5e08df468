package org.u2sa.interfaces.communication;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.u2sa.messages.schema.Origin;

/**
 * Counts the messages that were lost on their way over MQTT: those between two numbers of one
 * sender on one topic. What a sender sent before it was heard first is not missed. Safe for all
 * threads.
 */
public final class Gaps {
  /**
   * Senders and topics remembered; of one that falls silent and is forgotten, a gap is not seen.
   */
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
   * Takes note of a message that arrived, in whatever order.
   *
   * @param origin as the message has it; without one nothing can be counted
   * @return how many messages are missing right before this one
   */
  public synchronized long arrived(String topic, Optional<Origin> origin) {
    if (!origin.isPresent()) {
      return 0;
    }
    Stream stream = new Stream(origin.get().sender(), topic);
    long sequence = origin.get().sequence();
    Long before = last.get(stream);
    if (before != null && sequence <= before) {
      return 0; // sent twice, or kept by the broker from earlier
    }
    last.put(stream, sequence);
    long gap = before == null ? 0 : sequence - before - 1;
    missed += gap;
    return gap;
  }

  /** Forgets what came on some topics: the next message there is heard as if for the first time. */
  public synchronized void forget(Predicate<String> topics) {
    last.keySet().removeIf(stream -> topics.test(stream.topic()));
  }

  /** Messages missed since the start. */
  public synchronized long missed() {
    return missed;
  }
}
