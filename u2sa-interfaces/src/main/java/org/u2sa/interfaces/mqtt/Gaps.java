package org.u2sa.interfaces.mqtt;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import java.util.function.Predicate;
import org.u2sa.interfaces.time.SystemClock;
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

  /**
   * Repetitions after which, and time since the last new number after which they count as new [µs]:
   * somebody else used the sender's name with a higher number.
   */
  private static final int REPETITIONS = 3;

  private static final long REPEATED_FOR_MICROS = 5_000_000L;

  private static final class Heard {
    private long number;
    private long micros;
    private long repeated; // newest number that was not above it
    private int repetitions; // of growing numbers

    /** Whether a sequence of growing numbers below the last one has gone on for long. */
    private boolean isOvertaken(long sequence, long nowMicros) {
      repetitions = sequence > repeated ? repetitions + 1 : 1;
      repeated = sequence;
      return repetitions >= REPETITIONS && nowMicros - micros >= REPEATED_FOR_MICROS;
    }

    private void take(long sequence, long nowMicros) {
      number = sequence;
      micros = nowMicros;
      repetitions = 0;
      repeated = 0;
    }
  }

  private final LongSupplier micros;
  private final Map<Stream, Heard> last =
      new LinkedHashMap<>(64, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Stream, Heard> eldest) {
          return size() > REMEMBERED;
        }
      };
  private long missed;

  public Gaps() {
    this(new SystemClock()::micros);
  }

  /**
   * @param micros monotonic time [µs]
   */
  Gaps(LongSupplier micros) {
    this.micros = micros;
  }

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
    long now = micros.getAsLong();
    Heard heard = last.get(stream);
    if (heard != null && sequence <= heard.number && !heard.isOvertaken(sequence, now)) {
      return REPEATED; // or retained by the broker
    }
    boolean isNext = heard != null && sequence > heard.number;
    long gap = isNext ? sequence - heard.number - 1 : 0;
    last.computeIfAbsent(stream, any -> new Heard()).take(sequence, now);
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
