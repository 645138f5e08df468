package org.u2sa.service.inbox;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import org.u2sa.interfaces.time.Clock;

/**
 * Sources of one channel whose messages an inbox takes, the longest silent first. Bounded in number
 * and in the memory of their last messages, because services keep state per source. When there are
 * too many, one that has been silent for a while makes room for a new one; others stay.
 *
 * <p>Not thread-safe: guarded by the inbox.
 */
final class KnownSources {
  /**
   * Minimum silence of a source that makes room [µs], longer than any deadline of a message. No
   * clock is read while there is room, so it may be up to twice as long.
   */
  static final long SILENT_MICROS = 60 * Clock.MICROS_PER_SECOND;

  /** One source. */
  static final class Source {
    private ServiceInbox.Delivery waiting; // null if none
    private long period; // in which it was heard last
    private long bytes; // most that one of its messages took; 0 if they are short

    /** Its queued message on a latest-value channel; null if none. */
    ServiceInbox.Delivery waiting() {
      return waiting;
    }

    void waiting(ServiceInbox.Delivery delivery) {
      waiting = delivery;
    }
  }

  private final Clock clock;
  private final long maxBytes;
  private final Map<String, Source> known = new LinkedHashMap<>(16, 0.75f, true);
  private long period;
  private long sinceMicros; // start of the period
  private long bytes; // of all sources

  /**
   * @param maxBytes memory of the last messages of all sources with long ones; short ones, of at
   *     most this divided by the number of sources, always fit
   */
  KnownSources(Clock clock, long maxBytes) {
    this.clock = clock;
    this.maxBytes = maxBytes;
    sinceMicros = clock.micros();
  }

  /** A source that was heard before; null if it was not. */
  Source heard(String name) {
    Source source = known.get(name);
    if (source != null) {
      source.period = period;
    }
    return source;
  }

  /** Whether a new source may be {@link #add added}; forgets a silent one if there is no room. */
  boolean hasRoom() {
    return known.size() < ServiceInbox.MAX_SOURCES || forgetSilent();
  }

  private boolean forgetSilent() {
    long now = clock.micros();
    if (now - sinceMicros >= SILENT_MICROS) {
      period++;
      sinceMicros = now;
    }
    Iterator<Source> longestSilentFirst = known.values().iterator();
    while (longestSilentFirst.hasNext()) {
      Source source = longestSilentFirst.next();
      if (source.period >= period - 1) {
        return false; // heard in this period or the one before it, as are all that follow
      }
      if (source.waiting == null) {
        bytes -= source.bytes;
        longestSilentFirst.remove();
        return true;
      }
    }
    return false;
  }

  /**
   * Whether a message fits beside the last ones of the other sources. One that is no longer than an
   * earlier one of its source does, so that others cannot crowd it out.
   *
   * @param source null if it is new
   */
  boolean fits(Source source, int itsBytes) {
    long charged = charged(itsBytes);
    long before = source == null ? 0L : source.bytes;
    return charged <= before || bytes - before + charged <= maxBytes;
  }

  /** Adds a source; the caller has checked {@link #hasRoom}. */
  Source add(String name) {
    Source source = new Source();
    source.period = period;
    known.put(name, source);
    return source;
  }

  /** Records a message that was taken. */
  void takes(Source source, int itsBytes) {
    long charged = Math.max(source.bytes, charged(itsBytes));
    bytes += charged - source.bytes;
    source.bytes = charged;
  }

  /** Rounded up, because messages of one source vary in length. */
  private long charged(int itsBytes) {
    if (itsBytes <= maxBytes / ServiceInbox.MAX_SOURCES) {
      return 0L;
    }
    long rounded = Long.highestOneBit(itsBytes);
    return Math.min(rounded == itsBytes ? rounded : 2L * rounded, Math.max(itsBytes, maxBytes));
  }

  /** Forgets all. */
  void clear() {
    known.clear();
    bytes = 0L;
  }
}
