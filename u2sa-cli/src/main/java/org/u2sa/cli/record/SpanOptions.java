package org.u2sa.cli.record;

import org.u2sa.interfaces.BadInputException;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.playback.RecordedSpan;
import picocli.CommandLine.Option;

/**
 * The options {@code --from} and {@code --to}, seconds since a recording's first message; used as
 * {@code @Mixin SpanOptions}.
 */
public final class SpanOptions {
  private static final double NANOS = 1e9;

  @Option(
      names = "--from",
      paramLabel = "S",
      defaultValue = "0",
      description =
          "For a recording: start this many seconds after its first message. Default: ${DEFAULT-VALUE}.")
  private double fromS;

  @Option(
      names = "--to",
      paramLabel = "S",
      description =
          "For a recording: end this many seconds after its first message. Default: at its end.")
  private Double toS;

  /**
   * The selected part of a recording.
   *
   * @throws BadInputException if the recording has no messages in the span
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
