package org.u2sa.trials.campaign;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.cli.Main;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.report.ReportFile;

/**
 * Main class of a {@link WorkerProcess}, which executes runs sequentially: each line of standard
 * input is a request of {@link RunLine}, each line of standard output its answer. It exits at the
 * end of its input, and immediately when its parent process dies.
 */
final class WorkerMain {
  private static final byte[] NO_FILES = {};

  private WorkerMain() {}

  public static void main(String[] none) throws IOException {
    // Exit with the parent, because the result is no longer needed.
    ProcessHandle.current()
        .parent()
        .ifPresent(parent -> parent.onExit().thenRun(() -> Runtime.getRuntime().halt(1)));
    PrintStream answers = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    System.setOut(System.err); // stdout is for answers only
    BufferedReader asked =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    for (String line = asked.readLine(); line != null; line = asked.readLine()) {
      answers.println(answer(RunLine.order(line)));
    }
    System.exit(0); // even if a demo left threads running
  }

  private static String answer(RunLine.Order order) {
    List<String> arguments = new ArrayList<>(order.arguments());
    arguments.addAll(List.of("--out", order.out().toString()));
    try {
      FolderArchive.delete(order.out()); // left by an interrupted or lost attempt at the same run
    } catch (IOException e) {
      return RunLine.answered(failure(order, e), NO_FILES);
    }
    StringWriter output = new StringWriter();
    StringWriter errors = new StringWriter();
    int exit =
        Main.run(
            new PrintWriter(output), new PrintWriter(errors), arguments.toArray(String[]::new));
    RunAnswer answer = new RunAnswer(exit, output.toString(), errors.toString());
    try {
      return RunLine.answered(answer, settled(order, exit));
    } catch (IOException e) {
      return RunLine.answered(failure(order, e), NO_FILES);
    }
  }

  private static RunAnswer failure(RunLine.Order order, IOException e) {
    String why = "cannot read or delete " + order.out() + ": " + ReportFile.reason(e);
    return new RunAnswer(ExitCode.FAILED, "", why);
  }

  /** Deletes the run's files that are not kept. Returns the files to send. */
  private static byte[] settled(RunLine.Order order, int exit) throws IOException {
    boolean stay = order.keepsFiles() || exit != ExitCode.DONE;
    byte[] sent = stay && order.sendsFiles() ? FolderArchive.pack(order.out()) : NO_FILES;
    if (!stay || order.sendsFiles()) {
      FolderArchive.delete(order.out());
    }
    return sent;
  }
}
