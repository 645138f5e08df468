package org.u2sa.cli;

import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.u2sa.cli.command.CommandProvider;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.terminal.Console;
import org.u2sa.cli.terminal.PlainLines;
import picocli.CommandLine;
import picocli.CommandLine.Help;

/** Entry point of the program {@code u2sa}. */
public final class Main {
  /**
   * Logger of the MQTT library; referenced here because an unreferenced logger may be
   * garbage-collected and lose its level.
   */
  private static final Logger MQTT = Logger.getLogger("org.eclipse.paho.client.mqttv3");

  private Main() {}

  /** Runs one command and exits the virtual machine with its exit code ({@link ExitCode}). */
  public static void main(String[] args) {
    Console console = Console.ofProcess();
    PrintWriter out = new PrintWriter(System.out, true);
    PrintWriter err = new PrintWriter(System.err, true);
    Thread.setDefaultUncaughtExceptionHandler(new LostThreads(err));
    MQTT.setLevel(Level.OFF); // services log each lost link themselves
    System.exit(
        run(
            CommandTree.discover(err, args),
            new PlainLines(out, Optional.of(console)),
            new PlainLines(err, Optional.of(console)),
            Help.Ansi.AUTO,
            args));
  }

  /**
   * Runs one command without exiting the virtual machine, for programs and tests that use the
   * command line.
   *
   * @param out receives the command's output, without colours; flushed after each line if it
   *     auto-flushes
   * @param err receives errors
   * @return exit code, see {@link ExitCode}
   */
  public static int run(PrintWriter out, PrintWriter err, String... args) {
    return run(
        CommandTree.discover(err, args),
        new PlainLines(out),
        new PlainLines(err),
        Help.Ansi.OFF,
        args);
  }

  /** Runs one command, and returns its {@link ExitCode}. */
  static int run(
      List<CommandProvider> providers,
      PlainLines out,
      PlainLines err,
      Help.Ansi ansi,
      String... args) {
    CommandLine line = CommandTree.build(providers, err, ansi).setOut(out).setErr(err);
    try {
      return line.execute(args);
    } catch (Error e) { // picocli rethrows it; also reports a broken installation clearly
      RootCommand root = line.getCommand();
      return new ErrorAnswers(root::debug).answer(e, err);
    } finally {
      out.flush();
      err.flush();
    }
  }

  /**
   * Reports uncaught exceptions of threads. Paho's threads end that way when their client is closed
   * while connecting, as in a process stopped during startup; they get one line and no stack trace,
   * because the lost connection is handled elsewhere.
   */
  static final class LostThreads implements Thread.UncaughtExceptionHandler {
    private static final String PAHO = "org.eclipse.paho.";

    private final PrintWriter err;

    LostThreads(PrintWriter err) {
      this.err = err;
    }

    @Override
    public void uncaughtException(Thread thread, Throwable thrown) {
      StackTraceElement[] trace = thrown.getStackTrace();
      boolean ofPaho =
          thrown instanceof RuntimeException
              && trace.length > 0
              && trace[0].getClassName().startsWith(PAHO);
      err.println("u2sa: thread " + thread.getName() + " ended: " + thrown);
      if (!ofPaho) {
        thrown.printStackTrace(err);
      }
      err.flush();
    }
  }
}
