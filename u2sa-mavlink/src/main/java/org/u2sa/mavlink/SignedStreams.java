package org.u2sa.mavlink;

import java.util.HashMap;
import java.util.Map;

/**
 * Streams of signed packets. A packet is admitted once: each stream's timestamps must increase, and
 * those of a new stream must not be more than a minute old, nor older than this record, because it
 * does not know what an earlier run has admitted. Thread-safe.
 *
 * <p>The age is measured by the vehicle's clock, so that no station with a clock ahead makes others
 * outdated. Only a clock that has not been set follows the newest timestamp. A system's streams
 * that have become outdated make room for others; their packets are then too old for a new stream.
 */
final class SignedStreams {
  /** Refusal of a new stream because of its age. */
  static final String OUTDATED_STREAM = "outdated signature of a new stream";

  private static final long NEW_STREAM_TICKS = 6_000_000; // a minute
  private static final long WARNING_TICKS = 6_000_000; // so that a flood does not fill a log
  private static final int MAX_STREAMS = 64; // of a system
  private static final int SYSTEM_SHIFT = 16;

  private final Map<Integer, Map<Integer, Long>> systems = new HashMap<>(); // newest timestamps
  private final long began;
  private long newest;
  private long warned;

  /**
   * @param now the vehicle's clock [10 µs since 2015]; negative if it has not been set
   */
  SignedStreams(long now) {
    began = now;
    warned = now - WARNING_TICKS;
  }

  /**
   * Reason to reject a packet; empty if admitted, after which its timestamp is used up.
   *
   * @param stream system, component and link ID, a byte each
   * @param time the packet's timestamp
   * @param now the vehicle's clock [10 µs since 2015]; negative if it has not been set
   */
  synchronized String refusal(int stream, long time, long now) {
    Map<Integer, Long> streams =
        systems.computeIfAbsent(stream >> SYSTEM_SHIFT, system -> new HashMap<>());
    long oldest = oldest(now);
    Long before = streams.get(stream);
    if (isOutdated(before, time, oldest)) {
      return before == null ? OUTDATED_STREAM : "outdated signature";
    }
    if (before == null && streams.size() >= MAX_STREAMS) {
      streams.values().removeIf(each -> each < oldest);
      if (streams.size() >= MAX_STREAMS) {
        return "more than " + MAX_STREAMS + " signed streams of one system";
      }
    }
    streams.put(stream, time);
    newest = Math.max(newest, time);
    return "";
  }

  /** Whether a packet would be rejected because of its timestamp, which is not used up. */
  synchronized boolean isOutdated(int stream, long time, long now) {
    Map<Integer, Long> streams = systems.getOrDefault(stream >> SYSTEM_SHIFT, Map.of());
    return isOutdated(streams.get(stream), time, oldest(now));
  }

  private long oldest(long now) {
    long minuteAgo = reference(now) - NEW_STREAM_TICKS;
    return now > 0 ? Math.max(began, minuteAgo) : minuteAgo;
  }

  private long reference(long now) {
    return now > 0 ? now : newest;
  }

  /** Newest timestamp of a stream; 0 if it is not known. */
  synchronized long newest(int stream) {
    return systems.getOrDefault(stream >> SYSTEM_SHIFT, Map.of()).getOrDefault(stream, 0L);
  }

  /** Age of a packet [10 µs]. */
  synchronized long age(long time, long now) {
    return reference(now) - time;
  }

  /** Maximum {@link #age} of a new stream's first packet. */
  synchronized long maxAge(long now) {
    return reference(now) - oldest(now);
  }

  /** Whether a refused stream should be reported: once a minute. */
  synchronized boolean isWarningDue(long now) {
    boolean isDue = now - warned >= WARNING_TICKS;
    warned = isDue ? now : warned;
    return isDue;
  }

  private static boolean isOutdated(Long before, long time, long oldest) {
    return before == null ? time < oldest : time <= before;
  }
}
