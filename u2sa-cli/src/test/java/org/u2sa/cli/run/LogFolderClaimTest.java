package org.u2sa.cli.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;

/** Who may write logs and saved states into a folder. */
class LogFolderClaimTest {
  @TempDir private Path folder;

  @Test
  void of_folderOfAnotherRunningSystem_isRefusedUntilThatEnds() {
    Path logs = folder.resolve("logs");
    LogFolderClaim first = LogFolderClaim.of(logs, "rover");

    assertThatThrownBy(() -> LogFolderClaim.of(logs, "boat"))
        .isInstanceOf(BadInputException.class)
        .hasMessage(
            "--logs "
                + logs
                + ": system rover, which is running, writes its logs and saved states there; choose another folder for system boat");

    first.close();
    LogFolderClaim.of(logs, "boat").close();
  }

  @Test
  void of_processesOfOneSystem_shareTheFolder() {
    try (LogFolderClaim manager = LogFolderClaim.of(folder, "rover");
        LogFolderClaim service = LogFolderClaim.of(folder, "rover")) {
      assertThat(manager).isNotSameAs(service);
    }
  }

  @Test
  void of_folderThatCannotBe_isNotClaimed() throws IOException {
    Path file = Files.createFile(folder.resolve("file"));
    LogFolderClaim.of(file, "rover").close();
    LogFolderClaim.of(file, "boat").close();
  }

  @Test
  void of_markIsASymbolicLink_isRefusedAndTheOtherFileIsKept() throws IOException {
    Path other = Files.writeString(folder.resolve("other"), "kept");
    Path logs = Files.createDirectory(folder.resolve("logs"));
    Files.createSymbolicLink(logs.resolve(".system"), other);

    assertThatThrownBy(() -> LogFolderClaim.of(logs, "rover"))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining(".system in it is a symbolic link");
    assertThat(other).hasContent("kept");
  }
}
