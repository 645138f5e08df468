package org.u2sa.service.inbox;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicLongArray;
import org.u2sa.interfaces.time.Clock;

/**
 * Durations of a service's most recent callbacks and steps. Written lock-free by the service's
 * thread; readable from any thread.
 */
public final class CallbackTimes {
  static final int REMEMBERED = 256;

  /** Durations below this [µs], the majority, are counted instead of sorted. */
  private static final int SHORT_MICROS = 64;

  private static final double MEDIAN = 0.50;
  private static final double WORST_PERCENT = 0.99;

  private final AtomicLongArray micros = new AtomicLongArray(REMEMBERED);
  private final AtomicLong count = new AtomicLong(); // all, kept or not

  /** Median and 99th percentile [s]; 0 without data. */
  public record Percentiles(double p50S, double p99S) {}

  /** Adds a duration. Called by the service's thread only. */
  public void add(long tookMicros) {
    long before = count.get();
    micros.lazySet((int) (before % REMEMBERED), tookMicros);
    count.lazySet(before + 1);
  }

  public Percentiles percentiles() {
    int size = (int) Math.min(count.get(), REMEMBERED);
    if (size == 0) {
      return new Percentiles(0.0, 0.0);
    }
    int[] timesOf = new int[SHORT_MICROS]; // histogram of short durations
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
    Arrays.sort(longer, 0, longerOnes);
    return new Percentiles(
        Clock.seconds(nth(index(MEDIAN, size), timesOf, longer)),
        Clock.seconds(nth(index(WORST_PERCENT, size), timesOf, longer)));
  }

  private static int index(double fraction, int size) {
    return Math.min(size - 1, (int) (fraction * size));
  }

  /** The duration at an index in ascending order [µs]. */
  private static long nth(int index, int[] timesOf, long[] longer) {
    int left = index;
    for (int time = 0; time < timesOf.length; time++) {
      if (left < timesOf[time]) {
        return time;
      }
      left -= timesOf[time];
    }
    return longer[left];
  }
}
