package org.u2sa.estimation.fusion;

import java.util.ArrayDeque;
import java.util.Deque;

/**
 * The last measurements in the order of their times, and states after them to go on from. The
 * newest all keep their states, since what comes late mostly comes by a few; of older ones every
 * eighth does, and a measurement that is that late has a few more fused again. States are large,
 * and the fewer they are, the more of them stay in the processor's caches.
 */
final class History {
  private static final int RECENT = 32; // measurements that all keep the state after them
  private static final int STRIDE = 8; // of the others every so manyth does

  /** A measurement, and what it led to. */
  static final class Entry {
    final Measurement measurement = new Measurement();
    int source;
    private FilterState after; // null: not kept, or there has been none yet
  }

  private final Entry[] ring;
  private final Deque<FilterState> spare = new ArrayDeque<>();
  private FilterState base = new FilterState(); // before the oldest entry
  private int first;
  private int count;
  private int fused; // entries from the oldest on whose states are what they led to
  private int thinned; // entries from the oldest on of which only some keep their states

  /**
   * @param capacity measurements kept at least, once so many have come
   */
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

  /** The state before an entry, if all before are fused and the one before keeps its state. */
  FilterState before(int index) {
    return index == 0 ? base : at(index - 1).after;
  }

  /** Where the state after an entry is to be written: that before it, so far. */
  FilterState after(int index) {
    Entry entry = at(index);
    if (entry.after == null) {
      entry.after = spare.isEmpty() ? new FilterState() : spare.pop();
    }
    entry.after.copyFrom(before(index));
    return entry.after;
  }

  /** Begins anew from a state. */
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

  /** How many entries, from the oldest on, are fused; all later ones have yet to be, in order. */
  int fused() {
    return fused;
  }

  /** Takes note that all entries are fused. */
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

  /**
   * Whether a state is kept less than a stride before an entry; that before the oldest always is.
   */
  private boolean isNearKept(int index) {
    for (int i = index - 1; i > index - STRIDE; i--) {
      if (i < 0 || at(i).after != null) {
        return true;
      }
    }
    return false;
  }

  /** Whether anything has ever led here. */
  boolean isStarted() {
    return count > 0 || base.isStarted;
  }

  /** Time of the newest measurement [µs]. */
  long micros() {
    return count > 0 ? at(count - 1).measurement.micros() : base.micros;
  }

  /** Whether a measurement of that time would come before all that is known to have led here. */
  boolean isBefore(long micros) {
    return base.isStarted && micros < base.micros;
  }

  /**
   * Puts a measurement into its place: by time, at the same time by the source's name. If it is
   * full, the oldest must be fused.
   *
   * @return its index, and it and all after it have to be fused; -1 if it is older than what is
   *     kept
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
      fused--; // back to a state to go on from
    }
    thinned = Math.min(thinned, fused);
    return index;
  }

  /**
   * Forgets the oldest entries, if they are fused, as far as they are older than that time and one
   * of them keeps its state, which remains.
   */
  void forget(long micros) {
    int end = endOfOldest();
    while (end > 0 && at(end - 1).measurement.micros() < micros) {
      forgetOldest(end);
      end = endOfOldest();
    }
  }

  /** How many of the oldest entries there are up to the first that keeps its state; 0 for none. */
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

  /** The oldest is filled anew next: a short history stays in the processor's caches. */
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
