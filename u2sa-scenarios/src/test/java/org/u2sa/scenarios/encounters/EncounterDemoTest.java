package org.u2sa.scenarios.encounters;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.scenarios.run.CommandLineRun;

/** All services of a boat with a radar, in one encounter. */
class EncounterDemoTest {
  @TempDir private Path folder;

  private String result(String... more) throws IOException {
    List<String> arguments = new ArrayList<>(List.of("demo", "encounters", "--case", "dnv-02"));
    arguments.addAll(List.of("--summary-only", "--port", "0", "--out", folder.toString()));
    arguments.addAll(List.of(more));
    CommandLineRun run = CommandLineRun.of(arguments.toArray(new String[0]));
    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    return Files.readString(folder.resolve("encounters.txt"));
  }

  @Tag("long")
  @Test
  void demo_crossingVessel_isGivenWayTo() throws IOException {
    assertThat(result("--seed", "3"))
        .contains("CROSSING_GIVE_WAY  CROSSING_GIVE_WAY")
        .doesNotContain("!");
  }

  @Test
  void demo_crossingVesselInWindAndCurrent_isGivenWayTo() throws IOException {
    assertThat(result("--seed", "6", "--vary")).contains("CROSSING_GIVE_WAY").doesNotContain("!");
  }

  @Test
  void demo_unknownCase_isRefusedWithItsName() {
    CommandLineRun run = CommandLineRun.of("demo", "encounters", "--case", "dnv-99");

    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err()).contains("dnv-99").contains("expected all");
  }
}
