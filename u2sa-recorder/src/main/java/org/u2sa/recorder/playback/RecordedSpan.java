package org.u2sa.recorder.playback;

import org.u2sa.recorder.mcap.McapReader;

/**
 * Part of a recording.
 *
 * @param startNanos log time of the recording's first message [ns]
 * @param fromNanos earliest log time wanted [ns]
 * @param toNanos latest log time wanted [ns]
 */
public record RecordedSpan(long startNanos, long fromNanos, long toNanos) {
  private static final double NANOS = 1e9;

  /** The whole recording. */
  public static RecordedSpan all(McapReader reader) {
    return new RecordedSpan(reader.statistics().startNanos(), Long.MIN_VALUE, Long.MAX_VALUE);
  }

  /** Seconds from the recording's first message to a log time. */
  public double seconds(long logNanos) {
    return (logNanos - startNanos) / NANOS;
  }
}
