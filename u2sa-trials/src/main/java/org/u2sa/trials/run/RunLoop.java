package org.u2sa.trials.run;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.report.summary.RunReport;
import org.u2sa.report.summary.RunSeries;
import org.u2sa.trials.terminal.WaypointTable;

/** Executes one run, or several with consecutive seeds, and writes their output. */
final class RunLoop {
  /** One run. */
  @FunctionalInterface
  public interface Once {
    /** Executes the run until it ends or is interrupted; logs go to the directory. */
    RunReport run(Path directory, long seed, Interruption interruption) throws InterruptedException;
  }

  private final DemoOptions options;
  private final PrintWriter out;
  private final Terminal terminal;

  /**
   * @param out receives only the output of {@code --json}
   */
  public RunLoop(DemoOptions options, PrintWriter out) {
    this.options = options;
    this.out = out;
    terminal = options.terminal();
  }

  /**
   * Executes the requested number of runs and returns the exit code.
   *
   * @param name the demo's name, for the directory
   */
  public Integer run(String name, Once once) throws InterruptedException, IOException {
    try (Interruption interruption = new Interruption()) {
      return run(name, once, interruption);
    }
  }

  private Integer run(String name, Once once, Interruption interruption)
      throws InterruptedException, IOException {
    options.out().ifPresent(OutputFolder::requireUnused);
    Path directory = options.outDirectory(name, new SystemClock().micros());
    List<RunReport> reports = new ArrayList<>();
    for (int k = 0; k < options.runs() && (k == 0 || !interruption.isAsked()); k++) {
      Path runDirectory = options.runDirectory(directory, k);
      RunReport.prepare(runDirectory);
      RunReport.deleteSummary(runDirectory);
      RunReport report = started(once, runDirectory, options.seed() + k, interruption);
      if (options.summaryOnly()) {
        report.writeSummary(runDirectory);
      } else {
        report.write(runDirectory).ifPresent(terminal.out()::println);
      }
      WaypointTable.print(terminal, report.facts(), report.score());
      terminal.out().println("Files of the run: " + runDirectory);
      reports.add(withoutTrack(report)); // the tracks of many runs would exhaust the memory
    }
    RunSeries series = new RunSeries(reports);
    if (reports.size() > 1) {
      series.write(directory);
      terminal
          .out()
          .println(
              reports.stream().filter(r -> r.score().success()).count()
                  + " of "
                  + reports.size()
                  + " runs succeeded");
    }
    if (options.json()) {
      if (reports.size() > 1) {
        series.writeSummary(out);
      } else {
        reports.get(0).writeSummary(out);
      }
    }
    return series.success() ? ExitCode.DONE : ExitCode.FAILED;
  }

  private static RunReport started(Once once, Path directory, long seed, Interruption interruption)
      throws InterruptedException {
    try {
      return once.run(directory, seed, interruption);
    } catch (BadInputException e) {
      OutputFolder.withdraw(directory);
      throw e;
    }
  }

  private static RunReport withoutTrack(RunReport report) {
    return new RunReport(report.facts(), report.plan(), List.of(), report.score());
  }
}
