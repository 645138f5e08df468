package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Where the token of a broker on this host is, and which one is used. */
class LocalTokenTest {
  private static final int PORT = 1; // no broker of ours listens there

  @TempDir Path folder;
  private Path runtime;
  private AccountFolders session; // one with XDG_RUNTIME_DIR
  private AccountFolders bare;
  private Path file;

  @BeforeEach
  void moveIn() throws IOException {
    runtime = Files.createDirectory(folder.resolve("runtime"));
    session = new AccountFolders(runtime.toString(), folder.toString());
    bare = new AccountFolders("", folder.toString());
    file = folder.resolve(".u2sa/run").resolve(LocalToken.fileName("127.0.0.1", PORT));
  }

  private static void write(Path file, String token) throws IOException {
    AccountFolders.prepare(file.getParent());
    Files.write(file, token.getBytes(StandardCharsets.UTF_8));
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
  }

  private void write(String token) throws IOException {
    write(file, token);
  }

  private String read(String host) {
    return read(bare, host);
  }

  private static String read(AccountFolders folders, String host) {
    return LocalToken.read(folders, host, PORT).map(String::new).orElse("none");
  }

  @ParameterizedTest
  @CsvSource({
    "127.0.0.1, broker-1.token",
    "LocalHost, broker-1.token",
    "127.0.0.2, broker-1-127.0.0.2.token",
    "::1, broker-1-__1.token",
    "[::1], broker-1-__1.token",
    "boat.lan, broker-1-boat.lan.token",
    "a/../b, broker-1-a_.._b.token"
  })
  void file_eachAddress_isOneFileOfItsOwn(String address, String name) {
    assertThat(LocalToken.fileName(address, PORT)).isEqualTo(name);
  }

  @Test
  void read_ownersAlone_isTheTextWithoutItsLineEnd() throws IOException {
    write("secret\n");

    assertThat(read("127.0.0.1")).isEqualTo("secret");
    assertThat(read("localhost")).isEqualTo("secret");
  }

  @Test
  void read_noTokenForTheAddress_isNone() throws IOException {
    assertThat(read("127.0.0.1")).isEqualTo("none");
    write("secret");
    assertThat(read("127.0.0.9")).isEqualTo("none");
  }

  @Test
  void read_hostThatIsNotThisOne_isNoneThoughAFileIsThere() throws IOException {
    write("secret");
    Files.copy(file, file.resolveSibling(LocalToken.fileName("boat.lan", PORT)));

    assertThat(read("boat.lan")).isEqualTo("none");
    assertThat(LocalToken.missing(bare, "boat.lan", PORT)).isEmpty();
  }

  @Test
  void read_tokenInTheOtherFolder_isFoundFromBothSessions() throws IOException {
    write("secret");
    assertThat(read(session, "127.0.0.1")).isEqualTo("secret");

    Files.delete(file);
    assertThat(LocalToken.missing(session, "127.0.0.1", PORT))
        .containsExactly(runtime.resolve("u2sa").resolve(file.getFileName()), file);
    write(runtime.resolve("u2sa").resolve(file.getFileName()), "elsewhere");
    assertThat(read(session, "127.0.0.1")).isEqualTo("elsewhere");
    assertThat(LocalToken.missing(session, "127.0.0.1", PORT)).isEmpty();
  }

  @Test
  void read_twoTokens_isTheNewestInWhicheverFolder() throws IOException {
    Path other = runtime.resolve("u2sa").resolve(file.getFileName());
    write("home");
    write(other, "runtime");
    Files.setLastModifiedTime(file, FileTime.fromMillis(2_000));
    Files.setLastModifiedTime(other, FileTime.fromMillis(1_000));
    assertThat(read(session, "127.0.0.1")).isEqualTo("home");

    Files.setLastModifiedTime(other, FileTime.fromMillis(3_000));
    assertThat(read(session, "127.0.0.1")).isEqualTo("runtime");
  }

  @Test
  void read_folderThatOthersMayWriteTo_isNotUsed() throws IOException {
    write(runtime.resolve("u2sa").resolve(file.getFileName()), "theirs");
    Files.setPosixFilePermissions(runtime, PosixFilePermissions.fromString("rwxrwxrwx"));
    assertThat(read(session, "127.0.0.1")).isEqualTo("none");
    assertThat(session.all()).containsExactly(file.getParent());

    write("secret");
    Files.setPosixFilePermissions(file.getParent(), PosixFilePermissions.fromString("rwxrwx---"));
    assertThat(read(session, "127.0.0.1")).isEqualTo("none");
  }

  @Test
  void prepare_linkInPlaceOfTheFolder_isRefused() throws IOException {
    Path elsewhere = Files.createDirectory(folder.resolve("elsewhere"));
    Path link = Files.createSymbolicLink(folder.resolve("run"), elsewhere);

    assertThatThrownBy(() -> AccountFolders.prepare(link)).isInstanceOf(IOException.class);
  }

  @Test
  void read_openToOthers_isNone() throws IOException {
    write("secret");
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r--r--"));

    assertThat(read("127.0.0.1")).isEqualTo("none");
  }

  @Test
  void read_blankOrLong_isNone() throws IOException {
    write(" \n");
    assertThat(read("127.0.0.1")).isEqualTo("none");
    write("x".repeat(257));
    assertThat(read("127.0.0.1")).isEqualTo("none");
    write("x".repeat(256));
    assertThat(read("127.0.0.1")).hasSize(256);
  }

  @Test
  void login_ofASecuredBroker_isUserPasswordAndAuthorityUnlessATokenIsNewer() throws IOException {
    Path login = file.resolveSibling(LocalToken.loginFileName("127.0.0.1", PORT));
    write(login, LocalToken.loginText("ann", "secret", folder.resolve("ca.pem")));

    LocalToken.Login read = LocalToken.login(bare, "localhost", PORT).orElseThrow();
    assertThat(read.user()).isEqualTo("ann");
    assertThat(read.password()).isEqualTo("secret".toCharArray());
    assertThat(read.caFile()).isEqualTo(folder.resolve("ca.pem").toString());
    assertThat(LocalToken.login(bare, "boat.lan", PORT)).isEmpty();
    assertThat(read("localhost")).isEqualTo("none");

    write("secret");
    Files.setLastModifiedTime(file, FileTime.fromMillis(2_000));
    Files.setLastModifiedTime(login, FileTime.fromMillis(1_000));
    assertThat(LocalToken.login(bare, "localhost", PORT)).isEmpty();
  }

  @Test
  void login_openToOthersOrOfOtherForm_isNone() throws IOException {
    Path login = file.resolveSibling(LocalToken.loginFileName("127.0.0.1", PORT));
    write(login, "ann\nsecret\n");
    assertThat(LocalToken.login(bare, "localhost", PORT)).isEmpty();

    write(login, LocalToken.loginText("ann", "secret", folder));
    Files.setPosixFilePermissions(login, PosixFilePermissions.fromString("rw-r-----"));
    assertThat(LocalToken.login(bare, "localhost", PORT)).isEmpty();
  }
}
