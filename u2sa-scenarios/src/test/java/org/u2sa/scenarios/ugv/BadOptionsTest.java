package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.scenarios.run.CommandLineRun;

/** Changes of a demo that are not of their form, or would have no effect. */
class BadOptionsTest {
  @TempDir private Path directory;

  @ParameterizedTest(name = "--set \"{0}\"")
  @ValueSource(strings = {"", ":", "MissionManager", "MissionManager:LOOP"})
  void set_notOfItsForm_isBadInput(String text) {
    requireBad("expected SERVICE:VARIABLE=VALUE", "--set", text);
  }

  @Test
  void set_oneVariableTwice_isBadInput() {
    requireBad(
        "the variable is set to",
        "--set",
        "MissionManager:LOOP=true",
        "--set",
        "MissionManager:LOOP=false");
  }

  @Test
  void set_serviceThatIsNotThere_isBadInput() {
    requireBad("did you mean \"MissionManager\"?", "--set", "MisionManager:LOOP=true");
  }

  private void requireBad(String expected, String... options) {
    CommandLineRun run = CommandLineRun.demo("ugv", directory, options);

    assertThat(run.err()).startsWith("u2sa: --set: ").contains(expected);
    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
  }
}
