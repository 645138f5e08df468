package org.u2sa.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.command.ExitCode;

class CompletionTest {
  @TempDir private Path folder;

  private final StringWriter out = new StringWriter();

  static boolean hasBash() {
    return Files.isExecutable(Path.of("/bin/bash"));
  }

  private int run(String... arguments) {
    PrintWriter writer = new PrintWriter(out);
    return Main.run(writer, writer, arguments);
  }

  @Test
  @EnabledIf("hasBash")
  void completion_inBash_completesCommandsOptionsAndChannels() throws Exception {
    assertThat(run("completion", "bash")).isEqualTo(ExitCode.DONE);
    String ask =
        "\nask() { COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); COMPREPLY=(); _complete_u2sa;"
            + " echo \"${COMPREPLY[@]}\"; }\nask ./u2sa ec\nask ./u2sa echo --wh\nask ./u2sa echo sensed\n";
    Path script = Files.writeString(folder.resolve("ask.bash"), out + "\ncompopt() { :; }\n" + ask);
    Process bash =
        new ProcessBuilder("/bin/bash", script.toString()).redirectErrorStream(true).start();
    String said = new String(bash.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(bash.waitFor()).as(said).isZero();
    assertThat(said.lines().map(String::strip))
        .containsExactly("echo", "--where", "sensed-state sensed-objects");
  }

  @Test
  void completion_unknownShell_isBadInput() {
    assertThat(run("completion", "fish")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(out.toString()).contains("fish", "BASH");
  }
}
