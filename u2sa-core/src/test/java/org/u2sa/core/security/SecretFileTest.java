package org.u2sa.core.security;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.nio.file.attribute.UserPrincipal;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;

class SecretFileTest {
  @TempDir Path folder;

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private static void permit(Path path, String permissions) throws IOException {
    Files.setPosixFilePermissions(path, PosixFilePermissions.fromString(permissions));
  }

  @Test
  void write_overAWiderFileAndALeftOverOne_holdsTheContentForTheOwnerOnly() throws IOException {
    Path file = folder.resolve("key.pem");
    Files.writeString(file, "an older and longer key");
    permit(file, "rw-rw-rw-");
    Files.writeString(folder.resolve("key.pem.new"), "of a run that was cut off");

    SecretFile.write(file, bytes("key"));

    assertThat(file).hasContent("key");
    assertThat(SecretFile.tooOpen(file)).isEmpty();
    assertThat(folder).isDirectoryContaining(file::equals).isDirectoryNotContaining("glob:**.new");
  }

  /** Root may give files away: whose folder or file it is, stays able to read it. */
  @Test
  void write_byRootInAnotherUsersPlace_isTheOtherUsers() throws IOException {
    assumeTrue("root".equals(System.getProperty("user.name")), "needs to be root");
    UserPrincipal nobody =
        folder.getFileSystem().getUserPrincipalLookupService().lookupPrincipalByName("nobody");
    Files.setOwner(folder, nobody);
    Path created = folder.resolve("new.pem");
    SecretFile.write(created, bytes("key"));
    Files.setOwner(folder, Files.getOwner(folder.getRoot()));
    SecretFile.write(created, bytes("replaced"));

    assertThat(Files.getOwner(created)).isEqualTo(nobody);
    assertThat(created).hasContent("replaced");
  }

  @Test
  void write_whereNoFolderIs_namesTheFile() {
    assertThatThrownBy(() -> SecretFile.write(folder.resolve("none/key.pem"), bytes("key")))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("none/key.pem: cannot be written");
  }

  @ParameterizedTest
  @CsvSource({
    "rw-------, true",
    "r--------, true",
    "rw----r--, false",
    "rw--w----, false",
    "rwx------, false"
  })
  void tooOpen_permissionsOfAFile_onlyTheOwnersReadingAndWritingPass(String permissions, boolean ok)
      throws IOException {
    Path file = Files.createFile(folder.resolve("key.pem"));
    permit(file, permissions);

    assertThat(SecretFile.tooOpen(file).isEmpty()).isEqualTo(ok);
    if (!ok) {
      assertThat(SecretFile.tooOpen(file))
          .get()
          .asString()
          .contains(file + ": users other", "chmod 600");
    }
  }

  @ParameterizedTest
  @CsvSource({"rwx------, true", "rwxr-xr-x, true", "rwx-w----, false", "rwx----w-, false"})
  void tooOpenFolder_permissions_nobodyElseMayReplaceFiles(String permissions, boolean ok)
      throws IOException {
    permit(folder, permissions);

    assertThat(SecretFile.tooOpenFolder(folder).isEmpty()).isEqualTo(ok);
    if (!ok) {
      assertThat(SecretFile.tooOpenFolder(folder)).get().asString().contains("chmod 700");
    }
  }

  @Test
  void tooOpen_whatIsNotThere_isSaidAndNotTakenForClosed() {
    Path none = folder.resolve("none");
    assertThat(SecretFile.tooOpen(none)).get().asString().contains(none + ": its permissions");
    assertThat(SecretFile.tooOpenFolder(none)).get().asString().contains(none + ": its perm");
  }

  /** A file system without such permissions, as a zip's is, has nothing to say against a file. */
  @Test
  void tooOpen_whereThereAreNoSuchPermissions_isNot() throws IOException {
    URI archive = URI.create("jar:" + folder.resolve("archive.zip").toUri());
    try (FileSystem zip = FileSystems.newFileSystem(archive, Map.of("create", "true"))) {
      Path file = zip.getPath("/users.txt");
      SecretFile.write(file, bytes("x"));
      assertThat(Files.readAllBytes(file)).isEqualTo(bytes("x"));
      assertThat(SecretFile.tooOpen(file)).isEmpty();
      assertThat(SecretFile.tooOpenFolder(zip.getPath("/"))).isEmpty();
    }
  }

  private SecurityDirectory complete() {
    SecurityDirectory directory = new SecurityDirectory(folder);
    for (Path file :
        new Path[] {
          directory.authority(),
          directory.authorityKey(),
          directory.certificate(),
          directory.key(),
          directory.users()
        }) {
      SecretFile.write(file, bytes("x"));
    }
    return directory;
  }

  @Test
  void directoryCheck_completeAndClosed_passesWithoutTheAuthoritysKey() throws IOException {
    SecurityDirectory directory = complete();
    Files.delete(directory.authorityKey());
    directory.check();
    assertThat(directory.authority()).isEqualTo(folder.resolve("ca.pem")).exists();
  }

  @ParameterizedTest
  @ValueSource(strings = {"server.pem", "server-key.pem", "users.txt"})
  void directoryCheck_fileMissing_namesItAndWhatMakesIt(String missing) throws IOException {
    SecurityDirectory directory = complete();
    Files.delete(folder.resolve(missing));

    assertThatThrownBy(directory::check)
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining(
            folder + "\": missing " + missing + "; create it with ./u2sa security init");
  }

  @ParameterizedTest
  @ValueSource(strings = {"server-key.pem", "users.txt", "ca-key.p12"})
  void directoryCheck_secretForOthersToRead_isRefused(String open) throws IOException {
    SecurityDirectory directory = complete();
    permit(folder.resolve(open), "rw-r--r--");

    assertThatThrownBy(directory::check)
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining(folder.resolve(open) + ": users other than its owner may use it");
  }

  @Test
  void directoryCheck_folderForOthersToWrite_isRefused() throws IOException {
    SecurityDirectory directory = complete();
    permit(folder, "rwxrwxrwx");

    assertThatThrownBy(directory::check)
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining(folder + ": users other than its owner may replace its files");
  }
}
