package org.u2sa.core.estimation.fusion;

/**
 * The last measurements in the order of their times, each with the state after it. Made once: what
 * falls out at the old end is filled again at the new one.
 */
final class History {
  /** A measurement, and what it led to. */
  static final class Entry {
    final Measurement measurement = new Measurement();
    FilterState after = new FilterState();
    int source;
  }

  private final Entry[] ring;
  private FilterState base = new FilterState(); // before the oldest entry
  private int first;
  private int count;
  private int fused; // entries from the oldest on whose states are what they led to

  History(int capacity) {
    ring = new Entry[capacity];
    for (int i = 0; i < capacity; i++) {
      ring[i] = new Entry();
    }
  }

  int count() {
    return count;
  }

  Entry at(int index) {
    return ring[(first + index) % ring.length];
  }

  /** The state before an entry. */
  FilterState before(int index) {
    return index == 0 ? base : at(index - 1).after;
  }

  /** Begins anew from a state. */
  void restart(FilterState from) {
    base.copyFrom(from);
    first = 0;
    count = 0;
    fused = 0;
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
   * Puts a measurement into its place: by time, at the same time by the source's name.
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
      forgetOldest();
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
    return index;
  }

  /**
   * Forgets the oldest entries, if they are fused, as far as they are older than that time; the
   * state after them remains.
   */
  void forget(long micros) {
    while (fused > 0 && at(0).measurement.micros() < micros) {
      forgetOldest();
    }
  }

  /** The oldest is filled anew next: a short history stays in the processor's caches. */
  private void forgetOldest() {
    Entry oldest = at(0);
    FilterState unused = base;
    base = oldest.after;
    oldest.after = unused;
    int next = (first + count) % ring.length;
    ring[first] = ring[next];
    ring[next] = oldest;
    first = (first + 1) % ring.length;
    count--;
    fused--;
  }

  private static boolean comesBefore(Measurement a, Measurement b) {
    return a.micros() < b.micros()
        || a.micros() == b.micros() && a.source().compareTo(b.source()) < 0;
  }
}
