package org.u2sa.report.score;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * Samples of one run, oldest first, in bounded memory: when full, drops every other sample and
 * halves the sampling rate, so that a run of any length keeps evenly spaced samples. Samples at
 * which leg or phase changes survive the first thinnings. Not thread-safe.
 */
public final class Track {

  /** Capacity for two hours at 20 Hz, about 20 MB. */
  public static final int DEFAULT_CAPACITY = 150_000;

  private static final int MIN_CAPACITY = 4;
  private static final long LARGEST_STRIDE = 1L << 40; // prevents overflow

  private final int capacity;
  private final List<TrackSample> samples = new ArrayList<>();
  private long appended;
  private long stride = 1;

  public Track() {
    this(DEFAULT_CAPACITY);
  }

  /**
   * @param capacity maximum number of samples
   * @throws IllegalArgumentException if less than 4
   */
  public Track(int capacity) {
    if (capacity < MIN_CAPACITY) {
      throw new IllegalArgumentException(
          "capacity: " + capacity + ", expected " + MIN_CAPACITY + " or more");
    }
    this.capacity = capacity;
  }

  /**
   * Adds the next sample, or skips it if the track is thinned.
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

  /**
   * Changes the target of the samples after a time, once it is known which of several goals was
   * pursued. These samples then belong to no line between waypoints.
   */
  public void pursued(double afterS, int leg) {
    for (int i = samples.size() - 1; i >= 0 && samples.get(i).timeS() > afterS; i--) {
      samples.set(i, samples.get(i).towards(leg));
    }
  }

  /** Removes a target from all samples so far, because its position has changed since. */
  public void abandoned(int leg) {
    samples.replaceAll(sample -> sample.leg() == leg ? sample.towards(-1) : sample);
  }

  /** Kept samples, oldest first; a view that must not be used while appending. */
  public List<TrackSample> samples() {
    return Collections.unmodifiableList(samples);
  }

  private void thin() {
    stride = Math.min(2 * stride, LARGEST_STRIDE);
    if (keepEveryOther(true) > capacity * 3 / 4) {
      keepEveryOther(false); // mostly changes: the memory limit has priority
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
