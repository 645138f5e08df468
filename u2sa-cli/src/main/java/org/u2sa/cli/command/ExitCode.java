package org.u2sa.cli.command;

/** Exit codes of {@code u2sa}. */
public final class ExitCode {

  /** Success; for a mission, every goal was reached. */
  public static final int DONE = 0;

  /** The run failed: a goal was missed, or something unexpected happened. */
  public static final int FAILED = 1;

  /** Invalid input (command, option, configuration, mission); nothing was started. */
  public static final int BAD_INPUT = 2;

  private ExitCode() {}
}
