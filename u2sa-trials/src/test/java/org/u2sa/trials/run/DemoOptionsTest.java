package org.u2sa.trials.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

class DemoOptionsTest {

  /** A demo that does nothing with its options. */
  @Command(name = "any")
  private static final class AnyDemo {
    @Mixin private final DemoOptions options = new DemoOptions();
  }

  private static final long SOME_TIME_MICROS = 1_790_000_000_000_000L;

  @TempDir private Path directory;

  private static DemoOptions parsed(String... args) {
    AnyDemo command = new AnyDemo();
    new CommandLine(command).parseArgs(args);
    return command.options;
  }

  @Test
  void options_none_haveDefaults() {
    DemoOptions options = parsed();
    assertThat(options.seed()).isEqualTo(1);
    assertThat(options.runs()).isEqualTo(1);
    assertThat(options.mission()).isEmpty();
    assertThat(options.json()).isFalse();
    assertThat(options.realtime()).isFalse();
  }

  @Test
  void outDirectory_noSeed_isNamedByTime() {
    assertThat(parsed().outDirectory("cessna", SOME_TIME_MICROS).toString())
        .matches("out.cessna-\\d{8}-\\d{6}");
  }

  @Test
  void outDirectory_seed_isNamedBySeed() {
    assertThat(parsed("--seed", "7").outDirectory("cessna", SOME_TIME_MICROS))
        .isEqualTo(Paths.get("out", "cessna-seed7"));
  }

  @Test
  void outDirectory_given_isThat() {
    assertThat(parsed("--out", "here", "--seed=7").outDirectory("cessna", SOME_TIME_MICROS))
        .isEqualTo(Paths.get("here"));
  }

  @Test
  void runDirectory_severalRuns_isNumbered() {
    assertThat(parsed().runDirectory(directory, 0)).isEqualTo(directory);
    assertThat(parsed("--runs", "3").runDirectory(directory, 2))
        .isEqualTo(directory.resolve("run-03"));
  }

  @Test
  void mission_readableFile_isTaken() throws Exception {
    Path file = Files.createFile(directory.resolve("m.xml"));
    assertThat(parsed("--mission", file.toString()).mission()).contains(file);
  }

  @Test
  void mission_noSuchFile_isRefused() {
    assertThatThrownBy(() -> parsed("--mission", "nowhere.xml"))
        .isInstanceOf(CommandLine.ParameterException.class)
        .hasMessageContaining("--mission nowhere.xml: no such file");
  }

  @Test
  void runs_zero_isRefused() {
    assertThatThrownBy(() -> parsed("--runs", "0"))
        .hasMessageContaining("--runs 0: expected 1 or more");
  }

  @Test
  void terminal_json_isStandardError() {
    AnyDemo command = new AnyDemo();
    PrintWriter err = new PrintWriter(new StringWriter());
    CommandLine line = new CommandLine(command).setErr(err);
    line.parseArgs("--json");
    assertThat(command.options.terminal().out()).isSameAs(err);
    line.parseArgs();
    assertThat(command.options.terminal().out()).isSameAs(line.getOut());
  }
}
