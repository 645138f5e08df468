package org.u2sa.gcs.command;

import java.util.List;

/**
 * Adds commands to the command line {@code u2sa}. A module names its provider in {@code
 * META-INF/services/org.u2sa.gcs.command.CommandProvider}; the frame finds it through {@link
 * java.util.ServiceLoader}, so that the frame depends on no module that adds to it.
 *
 * <p>All providers are asked at each start of {@code u2sa}, {@code --help} included: constructors
 * of providers and commands must only set fields, and load what they need when the command runs.
 */
public interface CommandProvider {

  /** Where a command stands in the tree. */
  enum Group {
    /** Beside {@code u2sa demo}: {@code u2sa <command>}. */
    TOP_LEVEL,
    /** {@code u2sa demo <command>}: something to watch that needs nothing else installed. */
    DEMO
  }

  /**
   * One command and its place.
   *
   * @param group where it stands
   * @param command object of a class annotated with {@link picocli.CommandLine.Command} that is a
   *     {@link Runnable} or a {@link java.util.concurrent.Callable} of {@link Integer} (the exit
   *     code, see {@link ExitCode}); its first line of description is what the list of commands
   *     shows
   */
  record Contribution(Group group, Object command) {}

  /** The commands, in the order in which help lists them; new objects on each call. */
  List<Contribution> commands();
}
