package org.u2sa.service.inbox;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import org.u2sa.interfaces.time.Clock;

/**
 * Sources of one channel that an inbox accepts, the longest silent first. Bounded in number and in
 * the memory of their last messages, because services keep state per source. If full, a source that
 * has been silent for a while makes room for a new one. Guarded by the inbox.
 *
 * @param <W> type of a source's queued message
 */
final class KnownSources<W> {
  /**
   * Minimum silence before a source is evicted [µs], longer than any message deadline; up to twice
   * as long, measured from the first shortage, so that the clock is not read earlier.
   */
  static final long SILENT_MICROS = 60 * Clock.MICROS_PER_SECOND;

  static final class Source<W> {
    private W waiting; // null if none
    private long period; // in which it was last heard
    private long bytes; // size of its largest message; 0 if all are short

    /** Its queued message on a latest-value channel; null if none. */
    W waiting() {
      return waiting;
    }

    void waiting(W delivery) {
      waiting = delivery;
    }
  }

  private final Clock clock;
  private final int maxSources;
  private final long maxBytes;
  private final Map<String, Source<W>> known = new LinkedHashMap<>(16, 0.75f, true);
  private long period;
  private long sinceMicros = Clock.NEVER; // start of the period; NEVER until room was short
  private long bytes; // of all sources

  /**
   * @param maxBytes total size limit of the sources' last messages; messages of at most this
   *     divided by the number of sources always fit
   */
  KnownSources(Clock clock, int maxSources, long maxBytes) {
    this.clock = clock;
    this.maxSources = maxSources;
    this.maxBytes = maxBytes;
  }

  /** The source if heard before, or null. */
  Source<W> heard(String name) {
    Source<W> source = known.get(name);
    if (source != null) {
      source.period = period;
    }
    return source;
  }

  /** Whether a new source may be {@link #add added}; evicts a silent one if necessary. */
  boolean hasRoom() {
    return known.size() < maxSources || forgetSilent();
  }

  private boolean forgetSilent() {
    long now = clock.micros();
    if (sinceMicros == Clock.NEVER) {
      sinceMicros = now;
    } else if (now - sinceMicros >= SILENT_MICROS) {
      period++;
      sinceMicros = now;
    }
    Iterator<Source<W>> longestSilentFirst = known.values().iterator();
    while (longestSilentFirst.hasNext()) {
      Source<W> source = longestSilentFirst.next();
      if (source.period >= period - 1) {
        return false; // heard in this or the previous period, as are all later entries
      }
      if (source.waiting == null) {
        bytes -= source.bytes;
        longestSilentFirst.remove();
        return true;
      }
    }
    return false;
  }

  /** Whether a message {@link #fits}, possibly after forgetting silent sources. */
  boolean makesRoom(Source<W> source, int itsBytes) {
    boolean fits = fits(source, itsBytes);
    while (!fits && forgetSilent()) {
      fits = fits(source, itsBytes);
    }
    return fits;
  }

  /**
   * Whether a message fits the memory limit; it does if it is no longer than an earlier message of
   * its source.
   *
   * @param source null if it is new
   */
  private boolean fits(Source<W> source, int itsBytes) {
    long charged = charged(itsBytes);
    long before = source == null ? 0L : source.bytes;
    return charged <= before || bytes - before + charged <= maxBytes;
  }

  /** Adds a source; the caller has checked {@link #hasRoom}. */
  Source<W> add(String name) {
    Source<W> source = new Source<>();
    source.period = period;
    known.put(name, source);
    return source;
  }

  void takes(Source<W> source, int itsBytes) {
    long charged = Math.max(source.bytes, charged(itsBytes));
    bytes += charged - source.bytes;
    source.bytes = charged;
  }

  /** Rounded up, because messages of one source vary in length. */
  private long charged(int itsBytes) {
    if (itsBytes <= maxBytes / maxSources) {
      return 0L;
    }
    long rounded = Long.highestOneBit(itsBytes);
    return Math.min(rounded == itsBytes ? rounded : 2L * rounded, Math.max(itsBytes, maxBytes));
  }

  void clear() {
    known.clear();
    bytes = 0L;
  }
}
