package org.u2sa.gcs.command;

/** What {@code u2sa} answers to the shell. */
public final class ExitCode {

  /** Done; of a mission: every goal was reached. */
  public static final int DONE = 0;

  /** The run failed: a goal was missed, or something unexpected happened. */
  public static final int FAILED = 1;

  /** The input was wrong (command, option, configuration, mission); nothing was started. */
  public static final int BAD_INPUT = 2;

  private ExitCode() {}
}
