package org.u2sa.cli.record;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.command.ProgramVersion;
import org.u2sa.interfaces.JsonText;
import org.u2sa.interfaces.disk.RegularFile;
import org.u2sa.recorder.mcap.McapRecovery;
import org.u2sa.recorder.mcap.record.McapException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code u2sa recover FILE}: recovers a truncated recording. */
@Command(
    name = "recover",
    description = {
      "Repair a truncated or damaged recording.",
      "",
      "  ./u2sa recover out/drive/recording.mcap",
      "",
      "Copies every readable message, attachment and metadata record, even from a truncated "
          + "chunk. A chunk with a wrong checksum is left out. The damaged file is not changed. If no "
          + "message can be read, no file is written."
    })
public final class RecoverCommand extends BaseCommand {
  private static final String SUFFIX = ".mcap";

  @Parameters(paramLabel = "FILE", description = "The recording (MCAP).")
  private Path file;

  @Option(
      names = {"-o", "--out"},
      paramLabel = "FILE",
      description = "The repaired recording. Default: FILE with \"-recovered\" in its name.")
  private Path out;

  @Option(names = "--json", description = "Print what was recovered as JSON.")
  private boolean json;

  @Override
  public Integer call() throws IOException {
    RegularFile.require(file, "a recording (MCAP)");
    Path whole = out == null ? recovered() : out;
    if (Files.exists(whole)) {
      throw wrong(whole + " already exists; give another file with --out");
    }
    McapRecovery.Result result = McapRecovery.recover(file, whole, "u2sa " + ProgramVersion.text());
    if (result.messages() == 0) {
      Files.delete(whole);
      throw new McapException(
          file + ": no message can be recovered: " + result.trouble().orElse("it contains none"));
    }
    if (json) {
      print(
          new JsonText()
              .put("file", whole.toString())
              .put("messages", result.messages())
              .put("damagedChunks", result.damagedChunks())
              .put("trouble", result.trouble())
              .line());
      return ExitCode.DONE;
    }
    print(
        result
            .trouble()
            .map(trouble -> file + ": " + trouble)
            .orElse(file + " is complete and undamaged"));
    if (result.damagedChunks() > 0) {
      print(result.damagedChunks() + " damaged chunks left out");
    }
    print(result.messages() + " messages recovered into " + whole);
    return ExitCode.DONE;
  }

  private Path recovered() {
    String name = file.getFileName().toString();
    String stem = name.endsWith(SUFFIX) ? name.substring(0, name.length() - SUFFIX.length()) : name;
    return file.resolveSibling(stem + "-recovered" + SUFFIX);
  }
}
