package org.u2sa.scenarios.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.Main;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.scenarios.ugv.OneWaypoint;

class CampaignCommandTest {
  @TempDir private Path directory;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int campaign(String name, String... more) {
    List<String> arguments = new ArrayList<>(List.of("campaign"));
    System.setProperty("u2sa.home", Path.of("..").toAbsolutePath().normalize().toString());
    arguments.addAll(List.of(more));
    arguments.addAll(1, List.of("--out", directory.resolve(name).toString()));
    out.getBuffer().setLength(0);
    err.getBuffer().setLength(0);
    return Main.run(new PrintWriter(out), new PrintWriter(err), arguments.toArray(String[]::new));
  }

  private JsonNode summary(String name) throws IOException {
    return new ObjectMapper().readTree(directory.resolve(name).resolve("summary.json").toFile());
  }

  @Test
  void campaign_oneAndTwoProcesses_comeToTheSame() throws IOException {
    String[] runs = {
      "ugv",
      "--runs",
      "1",
      "--sweep",
      "payload=0,5",
      "--sweep",
      "estimator=fusing,pass_through",
      "--",
      "--mission",
      OneWaypoint.in(directory).toString()
    };
    assertThat(campaign("two", withJobs(2, runs))).as(err + "\n" + out).isEqualTo(ExitCode.DONE);
    JsonNode two = summary("two");
    assertThat(two.get("runs").asInt()).isEqualTo(4);
    assertThat(two.get("runsSucceeded").asInt()).isEqualTo(4);
    assertThat(directory.resolve("two/runs.csv")).content().hasLineCount(5);
    assertThat(directory.resolve("two/campaign.html"))
        .content()
        .contains("By payload", "By estimator");
    try (var left = Files.list(directory.resolve("two"))) {
      assertThat(left).noneMatch(Files::isDirectory);
    }

    String journal = Files.readString(directory.resolve("two/runs.jsonl"));
    Files.createDirectories(directory.resolve("one"));
    Files.writeString( // as if it had been broken off after its first run
        directory.resolve("one/runs.jsonl"),
        journal.lines().limit(2).reduce("", (all, line) -> all + line + "\n"));
    assertThat(campaign("one", withJobs(1, runs))).as(err + "\n" + out).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("1 of 4 runs were already complete");
    assertThat(summary("one").get("sha256")).isEqualTo(two.get("sha256"));

    Path mission = OneWaypoint.in(directory);
    Files.writeString(mission, Files.readString(mission) + "<!-- edited -->\n");
    assertThat(campaign("one", withJobs(1, runs))).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains(mission.toString(), "--out");
  }

  private static String[] withJobs(int jobs, String... rest) {
    List<String> all = new ArrayList<>(List.of("--jobs", Integer.toString(jobs)));
    all.addAll(List.of(rest));
    return all.toArray(String[]::new);
  }

  @Test
  void campaign_sameNameSweptTwice_isRefused() {
    assertThat(campaign("x", "ugv", "--sweep", "payload=0,5", "--sweep", "payload=7"))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("payload is already swept");
  }

  @Test
  void campaign_unknownDemo_isRefusedWithThoseThereAre() {
    assertThat(campaign("x", "boat")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("\"boat\"").contains("ugv");
  }

  @Test
  void campaign_unknownOptionOfDemo_isRefusedBeforeAnyRun() {
    assertThat(campaign("x", "ugv", "--runs", "1", "--", "--loopz", "1"))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("--loopz");
    assertThat(directory.resolve("x/summary.json")).doesNotExist();
  }
}
