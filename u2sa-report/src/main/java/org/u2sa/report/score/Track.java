package org.u2sa.report.score;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * The samples of one flight, oldest first, in bounded memory: when full, every other sample is
 * dropped and from then on only every other one is taken, so that a flight of any length keeps an
 * even track. Samples at which leg or phase changes outlive the first thinnings. Not for use by
 * several threads at once.
 */
public final class Track {

  /** Room for two hours at 20 samples a second, some 20 MB. */
  public static final int DEFAULT_CAPACITY = 150_000;

  private static final int LEAST_CAPACITY = 4;
  private static final long LARGEST_STRIDE = 1L << 40; // a flight made of changes thins without end

  private final int capacity;
  private final List<TrackSample> samples = new ArrayList<>();
  private long appended;
  private long stride = 1;

  public Track() {
    this(DEFAULT_CAPACITY);
  }

  /**
   * @param capacity most samples to keep
   * @throws IllegalArgumentException if less than 4
   */
  public Track(int capacity) {
    if (capacity < LEAST_CAPACITY) {
      throw new IllegalArgumentException(
          "capacity: " + capacity + ", expected " + LEAST_CAPACITY + " or more");
    }
    this.capacity = capacity;
  }

  /**
   * Takes the next sample, or leaves it out when the track is thinned.
   *
   * @throws IllegalArgumentException if it is not later than the last one
   */
  public void append(TrackSample sample) {
    TrackSample last = samples.isEmpty() ? null : samples.get(samples.size() - 1);
    if (last != null && sample.timeS() <= last.timeS()) {
      throw new IllegalArgumentException(
          "timeS: " + sample.timeS() + " does not come after " + last.timeS());
    }
    boolean wanted = appended % stride == 0 || changes(last, sample);
    appended++;
    if (!wanted) {
      return;
    }
    if (samples.size() == capacity) {
      thin();
    }
    samples.add(sample);
  }

  /** The samples kept, oldest first; a view that must not be used while appending. */
  public List<TrackSample> samples() {
    return Collections.unmodifiableList(samples);
  }

  private void thin() {
    stride = Math.min(2 * stride, LARGEST_STRIDE);
    if (keepEveryOther(true) > capacity * 3 / 4) {
      keepEveryOther(false); // a flight made of changes: the bound comes first
    }
  }

  private int keepEveryOther(boolean keepChanges) {
    List<TrackSample> kept = new ArrayList<>(capacity);
    for (int i = 0; i < samples.size(); i++) {
      if (i % 2 == 0 || keepChanges && changes(samples.get(i - 1), samples.get(i))) {
        kept.add(samples.get(i));
      }
    }
    samples.clear();
    samples.addAll(kept);
    return samples.size();
  }

  private static boolean changes(TrackSample before, TrackSample sample) {
    return before != null
        && (before.leg() != sample.leg() || !before.phase().equals(sample.phase()));
  }
}
