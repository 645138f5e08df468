package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;

/** Which files are closed enough for a password. */
class SecretFilesTest {
  @TempDir Path folder;
  private Path file;

  @BeforeEach
  void write() throws IOException {
    file = Files.write(folder.resolve("password"), new byte[] {'x'});
  }

  private void permit(String permissions) throws IOException {
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString(permissions));
  }

  @ParameterizedTest
  @ValueSource(strings = {"rw----r--", "rw-----w-", "rw-r-----", "rw--w----"})
  void requireClosed_othersMayUseIt_isRefused(String permissions) throws IOException {
    permit(permissions);

    assertThatThrownBy(() -> SecretFiles.requireClosed("PASSWORD FILE", file))
        .isInstanceOf(BadInputException.class)
        .hasMessage(
            "PASSWORD FILE \"" + file + "\": users other than its owner may use it; chmod 600 it");
  }

  @ParameterizedTest
  @ValueSource(strings = {"rw-------", "r--------"})
  void requireClosed_ownersAlone_isContent(String permissions) throws IOException {
    permit(permissions);

    assertThatCode(() -> SecretFiles.requireClosed("PASSWORD FILE", file))
        .doesNotThrowAnyException();
  }

  @ParameterizedTest
  @CsvSource({"rw-r--r--, true", "rw-rw-r--, true", "rw-r--rw-, false", "rw-r---w-, false"})
  void requireOwnersWord_whoMayWrite_decides(String permissions, boolean ok) throws IOException {
    permit(permissions);

    Throwable refusal = catchThrowable(() -> SecretFiles.requireOwnersWord("CA FILE", file));

    assertThat(refusal == null).isEqualTo(ok);
    assertThat(ok || refusal.getMessage().endsWith("may write it; chmod o-w it")).isTrue();
  }

  @Test
  void requireClosed_folder_isRefused() {
    assertThatThrownBy(() -> SecretFiles.requireClosed("PASSWORD FILE", folder))
        .isInstanceOf(BadInputException.class)
        .hasMessage("PASSWORD FILE \"" + folder + "\" is not a regular file");
  }

  @Test
  void requireClosed_notThere_isLeftToWhoeverReadsIt() {
    assertThatCode(() -> SecretFiles.requireClosed("PASSWORD FILE", folder.resolve("none")))
        .doesNotThrowAnyException();
  }
}
