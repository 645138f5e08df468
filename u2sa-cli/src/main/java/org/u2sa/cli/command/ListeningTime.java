package org.u2sa.cli.command;

import org.u2sa.interfaces.time.Clock;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Listening time of a command; used as {@code @Mixin ListeningTime time}. */
public final class ListeningTime {
  private static final long MICROS = 1_000_000L;

  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  private double forS = Double.POSITIVE_INFINITY;

  @Option(
      names = "--for",
      paramLabel = "S",
      description = "End after this many seconds. Default: at Ctrl-C.")
  private void forSeconds(double value) {
    if (!(value > 0.0)) {
      throw new ParameterException(
          command.commandLine(), "--for " + value + ": expected more than 0 s");
    }
    forS = value;
  }

  /** Whether a duration was set. */
  public boolean isBounded() {
    return forS < Double.POSITIVE_INFINITY;
  }

  /** End of the time [µs], given its start; {@link Clock#NEVER} if unlimited. */
  public long end(long beganMicros) {
    return isBounded() ? beganMicros + Clock.micros(forS) : Clock.NEVER;
  }

  /** Whether the duration has elapsed. */
  public boolean isOver(long beganMicros, long nowMicros) {
    return nowMicros - beganMicros >= forS * MICROS;
  }
}
