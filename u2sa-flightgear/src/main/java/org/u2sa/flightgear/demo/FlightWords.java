package org.u2sa.flightgear.demo;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import org.u2sa.gcs.DemoOptions;
import org.u2sa.gcs.report.RunReport;
import org.u2sa.gcs.terminal.Terminal;
import org.u2sa.gcs.terminal.WaypointTable;
import picocli.CommandLine.Model.CommandSpec;

/** What is said after a flight. */
final class FlightWords {
  private FlightWords() {}

  static void end(DemoOptions options, CommandSpec command, RunReport report, Path directory)
      throws IOException {
    Terminal terminal = options.terminal();
    WaypointTable.print(terminal, report.score());
    terminal.out().println("Files of the run: " + directory);
    terminal.out().flush();
    if (options.json()) {
      PrintWriter out = command.commandLine().getOut();
      report.writeSummary(out);
      out.flush();
    }
  }
}
