package org.u2sa.cli.look;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.log.LogLevelEnum;

class LogFolderTest {
  @TempDir private Path folder;

  private void append(String file, String text) throws IOException {
    Files.writeString(
        folder.resolve(file), text, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
  }

  @Test
  void more_severalFiles_areOneStreamByTime() throws IOException {
    append("A.log", "2026-01-01T00:00:01.000000Z | INFO | A | 1 | first\n");
    append("A.log", "2026-01-01T00:00:03.000000Z | ERROR | A | 1 | third\n    at trace\n");
    append("B.log", "2026-01-01T00:00:02.000000Z | WARN | B | 2 | second | with a bar\n");
    assertThat(new LogFolder(folder).more())
        .extracting(LogLine::text)
        .containsExactly("first", "second | with a bar", "third\n    at trace");
  }

  @Test
  void more_again_hasOnlyWhatIsNewAndWhole() throws IOException {
    LogFolder logs = new LogFolder(folder);
    append("A.log", "2026-01-01T00:00:01.000000Z | INFO | A | 1 | one\n2026-01-01T00:00:02");
    assertThat(logs.more()).extracting(LogLine::text).containsExactly("one");
    assertThat(logs.more()).isEmpty();
    append("A.log", ".000000Z | DEBUG | A | 1 | two\n");
    append("C.log", "2026-01-01T00:00:00.000000Z | INFO | C | 1 | new file\n");
    assertThat(logs.more()).extracting(LogLine::text).containsExactly("new file", "two");
    assertThat(logs.more()).isEmpty();
  }

  @Test
  void more_fileThatBeganAnew_isReadFromItsBeginning() throws IOException {
    LogFolder logs = new LogFolder(folder);
    append("A.log", "2026-01-01T00:00:01.000000Z | INFO | A | 1 | a long first line\n");
    logs.more();
    Files.writeString(folder.resolve("A.log"), "2026-01-01T00:00:02.000000Z | INFO | A | 1 | b\n");
    assertThat(logs.more()).extracting(LogLine::text).containsExactly("b");
  }

  @Test
  void of_levels_areRead() {
    assertThat(LogLine.of("2026-01-01T00:00:01.000000Z | WARN | Path Planner | 12 | x"))
        .containsExactly(
            new LogLine(
                "2026-01-01T00:00:01.000000Z", LogLevelEnum.WARN, "Path Planner", "12", "x"));
  }
}
