package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;

/** Which folders the programs of one account share. */
class AccountFoldersTest {
  @TempDir Path folder;

  @Test
  void of_nothingSet_theHomeFolder() {
    assertThat(AccountFolders.of(Map.of(), "/home/pat").all())
        .containsExactly(Paths.get("/home/pat/.u2sa/run"));
  }

  @Test
  void of_folderNamed_onlyThatFolder() {
    Map<String, String> environment =
        Map.of(AccountFolders.VARIABLE, folder.toString(), "XDG_RUNTIME_DIR", folder.toString());

    assertThat(AccountFolders.of(environment, "/home/pat").all()).containsExactly(folder);
  }

  @Test
  void of_relativeFolderNamed_saysWhatWasExpected() {
    assertThatThrownBy(
            () -> AccountFolders.of(Map.of(AccountFolders.VARIABLE, "account"), "/home/pat"))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("U2SA_ACCOUNT_FOLDER: \"account\" is not an absolute path");
  }

  /** Both builds set the variable. */
  @Test
  void ofProcess_inABuild_isNotTheRealHome() {
    assertThat(AccountFolders.ofProcess().all())
        .noneMatch(each -> each.startsWith(System.getProperty("user.home") + "/.u2sa"));
  }
}
