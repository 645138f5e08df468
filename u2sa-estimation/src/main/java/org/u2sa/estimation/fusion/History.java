package org.u2sa.estimation.fusion;

import java.util.ArrayDeque;
import java.util.Deque;
import org.u2sa.estimation.measurement.Measurement;

/**
 * Time-ordered buffer of recent measurements with snapshots of the state after them, from which
 * fusion can resume. The newest entries all keep a snapshot, because most late measurements are
 * only a few entries late; every eighth of the older entries does, so for an even later measurement
 * a few more must be fused again. States are large, so keeping fewer of them helps them to fit into
 * the CPU caches.
 */
final class History {
  private static final int RECENT = 32; // newest measurements, which all keep the state after them
  private static final int STRIDE = 8; // interval of snapshots among the older ones

  /** A measurement and the state after it. */
  static final class Entry {
    final Measurement measurement = new Measurement();
    int source;
    private FilterState after; // null if not kept or not fused yet
  }

  private final Entry[] ring;
  private final Deque<FilterState> spare = new ArrayDeque<>();
  private FilterState base = new FilterState(); // state before the oldest entry
  private int first;
  private int count;
  private int fused; // number of oldest entries that are fused
  private int thinned; // number of oldest entries already thinned

  History(int capacity) {
    ring = new Entry[capacity + STRIDE];
    for (int i = 0; i < ring.length; i++) {
      ring[i] = new Entry();
    }
  }

  int count() {
    return count;
  }

  Entry at(int index) {
    return ring[(first + index) % ring.length];
  }

  /**
   * State before an entry; all earlier entries must be fused, and the previous entry must hold its
   * state.
   */
  FilterState before(int index) {
    return index == 0 ? base : at(index - 1).after;
  }

  /** State to be updated to the one after an entry; initialised with the state before it. */
  FilterState after(int index) {
    Entry entry = at(index);
    if (entry.after == null) {
      entry.after = spare.isEmpty() ? new FilterState() : spare.pop();
    }
    entry.after.copyFrom(before(index));
    return entry.after;
  }

  /** Clears the history and restarts from a state. */
  void restart(FilterState from) {
    base.copyFrom(from);
    first = 0;
    count = 0;
    fused = 0;
    thinned = 0;
  }

  boolean isFull() {
    return count == ring.length;
  }

  /** Number of entries fused, from the oldest; all later ones must still be fused, in order. */
  int fused() {
    return fused;
  }

  /** Marks all entries as fused and thins out old snapshots. */
  void allFused() {
    fused = count;
    for (; thinned < count - RECENT; thinned++) {
      Entry entry = at(thinned);
      if (entry.after != null && isNearKept(thinned)) {
        spare.push(entry.after);
        entry.after = null;
      }
    }
  }

  /** Whether a state less than a stride before an entry is kept, as the oldest one's always is. */
  private boolean isNearKept(int index) {
    for (int i = index - 1; i > index - STRIDE; i--) {
      if (i < 0 || at(i).after != null) {
        return true;
      }
    }
    return false;
  }

  /** Whether there is a measurement or a started state. */
  boolean isStarted() {
    return count > 0 || base.isStarted;
  }

  /** Time of the newest measurement [µs]. */
  long micros() {
    return count > 0 ? at(count - 1).measurement.micros() : base.micros;
  }

  /** Whether a measurement of that time would precede the oldest state. */
  boolean isBefore(long micros) {
    return base.isStarted && micros < base.micros;
  }

  /**
   * Inserts a measurement in order of time, then source name. If the history is full, the oldest
   * entry must be fused.
   *
   * @return index of the entry, from which entries must be fused again; -1 if it is older than the
   *     history
   */
  int insert(Measurement m, int source) {
    if (isBefore(m.micros())) {
      return -1;
    }
    if (isFull()) {
      if (comesBefore(m, at(0).measurement)) {
        return -1;
      }
      forgetOldest(endOfOldest());
    }
    int index = count;
    Entry entry = at(index);
    while (index > 0 && comesBefore(m, at(index - 1).measurement)) {
      ring[(first + index) % ring.length] = at(index - 1);
      index--;
    }
    ring[(first + index) % ring.length] = entry;
    entry.measurement.copyFrom(m);
    entry.source = source;
    count++;
    fused = Math.min(fused, index);
    while (fused > 0 && at(fused - 1).after == null) {
      fused--; // back to the latest snapshot
    }
    thinned = Math.min(thinned, fused);
    return index;
  }

  /** Removes fused entries older than a time, up to the last snapshot, which becomes the base. */
  void forget(long micros) {
    int end = endOfOldest();
    while (end > 0 && at(end - 1).measurement.micros() < micros) {
      forgetOldest(end);
      end = endOfOldest();
    }
  }

  /** Number of oldest entries up to and including the first with a snapshot; 0 if none. */
  private int endOfOldest() {
    for (int i = 0; i < fused; i++) {
      if (at(i).after != null) {
        return i + 1;
      }
    }
    return 0;
  }

  private void forgetOldest(int entries) {
    Entry last = at(entries - 1);
    spare.push(base);
    base = last.after;
    last.after = null;
    for (int i = 0; i < entries; i++) {
      recycleOldest();
    }
    fused -= entries;
    thinned = Math.max(0, thinned - entries);
  }

  /** Recycles the oldest entry, so that a short history stays in the CPU caches. */
  private void recycleOldest() {
    Entry oldest = at(0);
    int next = (first + count) % ring.length;
    ring[first] = ring[next];
    ring[next] = oldest;
    first = (first + 1) % ring.length;
    count--;
  }

  private static boolean comesBefore(Measurement a, Measurement b) {
    return a.micros() < b.micros()
        || a.micros() == b.micros() && a.source().compareTo(b.source()) < 0;
  }
}
