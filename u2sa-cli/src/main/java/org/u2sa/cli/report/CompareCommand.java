package org.u2sa.cli.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
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

/** {@code u2sa compare}: compares several recorded runs on one page. */
@Command(
    name = "compare",
    description = {
      "Write one HTML page about several recorded runs: a table, and overlaid charts.",
      "",
      "  ./u2sa compare out/a/recording.mcap out/b/recording.mcap",
      "",
      "Times count from each run's first message. A track.csv beside a recording is its ground truth."
    })
public final class CompareCommand extends BaseCommand {

  @Parameters(arity = "2..*", paramLabel = "FILE", description = "The recordings (MCAP).")
  private List<Path> files;

  @Option(
      names = {"-o", "--out"},
      paramLabel = "FILE",
      defaultValue = "compare.html",
      description = "Output file. Default: ${DEFAULT-VALUE}.")
  private Path out;

  @Option(
      names = "--json",
      description = "Print the page's data as JSON instead of writing the page.")
  private boolean json;

  @Override
  public Integer call() throws IOException {
    for (Path file : files) {
      RegularFile.require(file, "a recording (MCAP)");
    }
    List<RunContent> runs = RunContent.readAll(files);
    for (Path file : files) {
      RecordingParts.othersNotRead(file).ifPresent(this::tell);
    }
    if (json) {
      List<JsonText> all = new ArrayList<>();
      runs.forEach(run -> all.add(run.json()));
      print(new JsonText().put("runs", all).line());
      return ExitCode.DONE;
    }
    RunPage.write(out, files.size() + " runs", runs.stream().map(RunContent::json).toList());
    print(out + " (" + Files.size(out) / 1000 + " kB)");
    return ExitCode.DONE;
  }
}
