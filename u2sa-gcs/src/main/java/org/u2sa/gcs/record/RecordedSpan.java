package org.u2sa.gcs.record;

import org.u2sa.interfaces.BadInputException;
import org.u2sa.recorder.mcap.McapReader;
import picocli.CommandLine.Option;

/**
 * Part of a recording, chosen by seconds since its first message; used as {@code @Mixin
 * RecordedSpan.Options}.
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

  /** The options {@code --from} and {@code --to}. */
  public static final class Options {
    @Option(
        names = "--from",
        paramLabel = "S",
        defaultValue = "0",
        description =
            "Of a recording: begin so many seconds after its first message. Default: ${DEFAULT-VALUE}.")
    private double fromS;

    @Option(
        names = "--to",
        paramLabel = "S",
        description =
            "Of a recording: end so many seconds after its first message. Default: at its end.")
    private Double toS;

    /**
     * Selected part of a recording.
     *
     * @throws BadInputException if it is empty
     */
    public RecordedSpan of(McapReader reader) {
      long start = reader.statistics().startNanos();
      long end = reader.statistics().endNanos();
      double lengthS = (end - start) / NANOS;
      if (!(fromS >= 0.0 && fromS <= lengthS)) {
        throw new BadInputException(
            "--from " + fromS + ": expected 0…" + lengthS + " s, the recording's length");
      }
      if (toS != null && !(toS >= fromS)) {
        throw new BadInputException("--to " + toS + ": expected " + fromS + " s (--from) or more");
      }
      return new RecordedSpan(
          start,
          start + Math.round(fromS * NANOS),
          toS == null ? end : start + Math.round(Math.min(toS, lengthS) * NANOS));
    }
  }
}
