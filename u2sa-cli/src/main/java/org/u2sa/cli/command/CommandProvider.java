package org.u2sa.cli.command;

import java.util.List;

/**
 * Adds commands to the command line {@code u2sa}. A module names its provider in {@code
 * META-INF/services/org.u2sa.cli.command.CommandProvider}; the frame finds it through {@link
 * java.util.ServiceLoader} and so depends on none of the contributing modules.
 *
 * <p>All providers are queried at each start of {@code u2sa}, even for {@code --help}, so
 * constructors of providers and commands must only set fields; load resources when the command
 * runs.
 */
public interface CommandProvider {

  /** Position of a command in the tree. */
  enum Group {
    /** Top level: {@code u2sa <command>}. */
    TOP_LEVEL,
    /** {@code u2sa demo <command>}: a demo that needs no further installation. */
    DEMO
  }

  /**
   * A command and its position.
   *
   * @param group position in the tree
   * @param command object of a class annotated with {@link picocli.CommandLine.Command} that is a
   *     {@link Runnable} or a {@link java.util.concurrent.Callable} of {@link Integer} (the exit
   *     code, see {@link ExitCode}); the first line of its description appears in the command list
   */
  record Contribution(Group group, Object command) {}

  /** Returns the commands in help order; new objects on each call. */
  List<Contribution> commands();
}
