package org.u2sa.cli.command;

import java.io.PrintWriter;
import java.util.concurrent.Callable;
import org.u2sa.cli.terminal.Terminal;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** A command with its outputs. {@link #call} returns the exit code, see {@link ExitCode}. */
public abstract class BaseCommand implements Callable<Integer> {
  @Spec private CommandSpec command;

  /** Command line that runs this command. */
  protected final CommandLine commandLine() {
    return command.commandLine();
  }

  /** Standard output. */
  protected final PrintWriter out() {
    return commandLine().getOut();
  }

  /** Terminal of {@link #out}. */
  protected final Terminal terminal() {
    return Terminal.detect(out(), System.getenv());
  }

  /** Prints a line, replacing control characters. */
  protected final void print(String line) {
    out().println(line);
  }

  /** Prints text that has its own line breaks, such as JSON. */
  protected final void printBlock(String text) {
    out().print(text);
    out().println();
  }

  /** Prints a note on standard error. */
  protected final void tell(String remark) {
    commandLine().getErr().println("u2sa: " + remark);
  }

  /** Error to throw for a wrong argument. */
  protected final ParameterException wrong(String what) {
    return new ParameterException(commandLine(), what);
  }

  /** A command that only has subcommands; by itself it prints its help. */
  public abstract static class Group extends BaseCommand {
    @Override
    public final Integer call() {
      commandLine().usage(out());
      return ExitCode.DONE;
    }
  }
}
