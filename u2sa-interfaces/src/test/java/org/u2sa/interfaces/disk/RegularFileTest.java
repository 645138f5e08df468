package org.u2sa.interfaces.disk;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;

class RegularFileTest {
  @TempDir private Path folder;

  @Test
  void problem_fileAndLinkToIt_isEmpty() throws IOException {
    Path file = Files.createFile(folder.resolve("a.mcap"));
    assertThat(RegularFile.problem(file)).isEmpty();
    assertThat(RegularFile.problem(Files.createSymbolicLink(folder.resolve("b"), file))).isEmpty();
  }

  @Test
  void problem_nothingOrFolder_isSaid() {
    assertThat(RegularFile.problem(folder.resolve("none"))).contains("no such file");
    assertThat(RegularFile.problem(folder)).contains("is a folder");
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void problem_namedPipe_isNotCalledAbsent() throws IOException, InterruptedException {
    Path pipe = folder.resolve("a.mcap");
    assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
    assertThat(RegularFile.problem(pipe).orElseThrow()).startsWith("is not a regular file");
    assertThatThrownBy(() -> RegularFile.refusePipe(pipe)).hasMessageContaining("named pipe");
    RegularFile.refusePipe(Path.of("/dev/null"));
  }

  @Test
  void require_nothing_namesThePathAndWhatIsExpected() {
    Path none = folder.resolve("none.mcap");
    assertThatThrownBy(() -> RegularFile.require(none, "a recording (MCAP)"))
        .isInstanceOf(BadInputException.class)
        .hasMessage(none + ": no such file; expected a recording (MCAP)");
  }
}
