package org.u2sa.cli.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.record.RecordingParts;
import org.u2sa.interfaces.JsonText;
import org.u2sa.interfaces.disk.RegularFile;
import org.u2sa.report.page.RunPage;
import org.u2sa.report.run.RunContent;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code u2sa report}: reports a recorded run on one page. */
@Command(
    name = "report",
    description = {
      "Write one self-contained HTML page about a recorded run.",
      "",
      "  ./u2sa demo ugv --record --out out/drive && ./u2sa report out/drive/recording.mcap",
      "  ./u2sa report flight.mcap --out flight.html",
      "",
      "Map with track, goals and obstacles; errors against ground truth with the estimator's standard deviations, if the demo's "
          + "track.csv is beside the recording or named by --truth; distance from the line, altitude, speed, actuators; age of "
          + "messages; condition of services; events (click one to move every cursor). Drag in a "
          + "chart to zoom."
    })
public final class ReportCommand extends BaseCommand {

  @Parameters(paramLabel = "FILE", description = "The recording (MCAP).")
  private Path file;

  @Option(
      names = {"-o", "--out"},
      paramLabel = "FILE",
      description = "Output file. Default: the recording's name with .html.")
  private Path out;

  @Option(
      names = "--truth",
      paramLabel = "FILE",
      description = "A demo's track.csv. Default: the one beside the recording, if any.")
  private Path truth;

  @Option(
      names = "--json",
      description = "Print the page's data as JSON instead of writing the page.")
  private boolean json;

  @Override
  public Integer call() throws IOException {
    for (Path each : truth == null ? List.of(file) : List.of(file, truth)) {
      String expected = each == file ? "a recording (MCAP)" : "a track.csv";
      RegularFile.require(each, expected);
    }
    RunContent run = RunContent.read(file, Optional.ofNullable(truth));
    RecordingParts.othersNotRead(file).ifPresent(this::tell);
    if (json) {
      print(new JsonText().put("runs", List.of(run.json())).line());
      return ExitCode.DONE;
    }
    Path page =
        out == null
            ? file.resolveSibling(
                file.getFileName().toString().replaceFirst("\\.mcap$", "") + ".html")
            : out;
    RunPage.write(page, file.toString(), List.of(run.json()));
    print(page + " (" + Files.size(page) / 1000 + " kB)");
    return ExitCode.DONE;
  }
}
