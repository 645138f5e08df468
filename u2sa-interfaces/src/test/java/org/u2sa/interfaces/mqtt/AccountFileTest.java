package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Files that stay where programs of every session of the account find them. */
@DisabledOnOs(OS.WINDOWS)
class AccountFileTest {
  @TempDir private Path directory;
  private final List<String> told = new CopyOnWriteArrayList<>(); // by the timer's thread, too
  private Path runtime;
  private Path inRuntime;
  private Path inHome;
  private AccountFile file;

  @BeforeEach
  void write() throws IOException {
    runtime = Files.createDirectory(directory.resolve("runtime"));
    inRuntime = runtime.resolve("u2sa/name");
    inHome = directory.resolve(".u2sa/run/name");
    file =
        new AccountFile(
            new AccountFolders(runtime.toString(), directory.toString()),
            "name",
            "content",
            told::add);
  }

  @AfterEach
  void close() {
    file.close();
  }

  @Test
  void new_twoFolders_isInBothForItsOwnerAloneUntilItIsClosed() throws IOException {
    for (Path each : List.of(inRuntime, inHome)) {
      assertThat(Files.readString(each)).isEqualTo("content");
      assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(each)))
          .isEqualTo("rw-------");
      assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(each.getParent())))
          .isEqualTo("rwx------");
    }
    file.close();
    assertThat(inRuntime).doesNotExist();
    assertThat(inHome).doesNotExist();
    file.writeMissing();
    assertThat(inHome).doesNotExist();
    assertThat(told).isEmpty();
  }

  @Test
  void writeMissing_folderWasRemovedAndMadeAnew_isThereAgain() throws IOException {
    Files.delete(inRuntime);
    Files.delete(inRuntime.getParent());
    Files.delete(runtime);
    file.writeMissing();
    assertThat(inRuntime).doesNotExist();

    Files.createDirectory(runtime);
    file.writeMissing();

    assertThat(Files.readString(inRuntime)).isEqualTo("content");
    assertThat(told).isEmpty();
  }

  @Test
  void writeMissing_laterProgramHasReplacedIt_staysItsFile() throws IOException {
    Files.writeString(inHome, "later");
    file.writeMissing();
    file.close();

    assertThat(Files.readString(inHome)).isEqualTo("later");
    assertThat(inRuntime).doesNotExist();
  }

  @Test
  void writeMissing_folderCannotBeMade_isToldOnceAndTheOtherIsWritten() throws IOException {
    Files.delete(inHome);
    Files.delete(inHome.getParent());
    Files.createSymbolicLink(inHome.getParent(), runtime);
    Files.delete(inRuntime);
    file.writeMissing();
    file.writeMissing();

    assertThat(told).singleElement().asString().contains(inHome.getParent().toString());
    assertThat(Files.readString(inRuntime)).isEqualTo("content");
    assertThat(runtime.resolve("name")).doesNotExist();
  }
}
