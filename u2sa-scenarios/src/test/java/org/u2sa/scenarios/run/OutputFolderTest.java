package org.u2sa.scenarios.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.trials.run.OutputFolder;

/** Two runs are never mixed in one folder. */
class OutputFolderTest {
  @TempDir Path directory;

  private static CommandLineRun campaign(Path out) {
    return CommandLineRun.of(
        "campaign",
        "ugv",
        "--out",
        out.toString(),
        "--runs",
        "1",
        "--jobs",
        "1",
        "--",
        "--loops",
        "0");
  }

  @ParameterizedTest
  @ValueSource(strings = {"summary.json", "mission.xml", "runs.jsonl", "run-07", "recording.mcap"})
  void demo_folderOfAnotherRun_isRefusedAndLeftAlone(String name) throws IOException {
    Files.writeString(directory.resolve(name), "mine");

    CommandLineRun run = CommandLineRun.demo("ugv", directory, "--loops", "1");

    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err())
        .contains("--out " + directory + ": holds " + name)
        .contains("expected an empty or new folder");
    assertThat(directory.resolve(name)).hasContent("mine");
    assertThat(Files.list(directory)).hasSize(1);
  }

  @Test
  void campaign_folderOfARun_isRefusedAndLeftAlone() throws IOException {
    Files.writeString(directory.resolve("summary.json"), "mine");

    CommandLineRun run = campaign(directory);

    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err()).contains("--out " + directory + ": holds summary.json");
    assertThat(directory.resolve("summary.json")).hasContent("mine");
  }

  @Test
  void campaign_folderOfAnotherCampaign_keepsItsSummary() throws IOException {
    Files.writeString(directory.resolve("runs.jsonl"), "{\"campaign\": \"another\"}\n");
    Files.writeString(directory.resolve("summary.json"), "mine");

    CommandLineRun run = campaign(directory);

    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err()).contains("contains the campaign \"another\"");
    assertThat(directory.resolve("summary.json")).hasContent("mine");
  }

  @Test
  void requireUnused_filesOfNoRun_areFine() throws IOException {
    Files.writeString(directory.resolve("notes.txt"), "mine");

    OutputFolder.requireUnused(directory);
    OutputFolder.requireUnused(directory.resolve("absent"));
  }
}
