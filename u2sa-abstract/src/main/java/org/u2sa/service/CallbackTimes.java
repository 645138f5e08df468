package org.u2sa.service;

import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicLongArray;
import org.u2sa.interfaces.time.Clock;

/**
 * How long the last callbacks and steps of a service took. Written by the service's thread without
 * a lock, since every message is measured; read by any.
 */
final class CallbackTimes {
  /** As many as are remembered. */
  static final int REMEMBERED = 256;

  /** Times shorter than this [µs], as most are, are counted rather than sorted. */
  private static final int SHORT_MICROS = 64;

  private static final double MEDIAN = 0.50;
  private static final double WORST_PERCENT = 0.99;

  private final AtomicLongArray micros = new AtomicLongArray(REMEMBERED);
  private final AtomicLong count = new AtomicLong(); // of all, remembered or not

  /**
   * What half and 99 % of the times did not exceed.
   *
   * @param p50S median [s]; 0 if there are no times
   * @param p99S 99th percentile [s]; 0 if there are no times
   */
  record Percentiles(double p50S, double p99S) {}

  /** Takes note of one more. Called by the service's thread only. */
  void add(long tookMicros) {
    long before = count.get();
    micros.lazySet((int) (before % REMEMBERED), tookMicros);
    count.lazySet(before + 1);
  }

  /** Of those that are remembered. */
  Percentiles percentiles() {
    int size = (int) Math.min(count.get(), REMEMBERED);
    if (size == 0) {
      return new Percentiles(0.0, 0.0);
    }
    int[] timesOf = new int[SHORT_MICROS]; // how often each short time comes
    long[] longer = new long[size];
    int longerOnes = 0;
    for (int i = 0; i < size; i++) {
      long took = micros.get(i);
      if (took >= 0 && took < SHORT_MICROS) {
        timesOf[(int) took]++;
      } else {
        longer[longerOnes++] = took;
      }
    }
    return new Percentiles(
        Clock.seconds(nth(index(MEDIAN, size), timesOf, longer, longerOnes)),
        Clock.seconds(nth(index(WORST_PERCENT, size), timesOf, longer, longerOnes)));
  }

  private static int index(double fraction, int size) {
    return Math.min(size - 1, (int) (fraction * size));
  }

  /** The time that would stand at an index if all were sorted, shortest first [µs]. */
  private static long nth(int index, int[] timesOf, long[] longer, int longerOnes) {
    int left = index;
    for (int time = 0; time < timesOf.length; time++) {
      if (left < timesOf[time]) {
        return time;
      }
      left -= timesOf[time];
    }
    return Selection.nth(longer, longerOnes, left);
  }
}
