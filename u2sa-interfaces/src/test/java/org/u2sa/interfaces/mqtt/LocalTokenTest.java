package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Where the token of a broker on this host is, and which one is used. */
class LocalTokenTest {
  private static final int PORT = 1; // no broker of ours listens there

  private final String home = System.getProperty("user.home");
  @TempDir Path folder;
  private Path file; // in $XDG_RUNTIME_DIR where a machine has it

  @BeforeEach
  void moveIn() {
    System.setProperty("user.home", folder.toString());
    file = LocalToken.file("127.0.0.1", PORT);
  }

  @AfterEach
  void delete() throws IOException {
    System.setProperty("user.home", home);
    Files.deleteIfExists(file);
  }

  private void write(String token) throws IOException {
    Files.createDirectories(file.getParent());
    Files.write(file, token.getBytes(StandardCharsets.UTF_8));
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
  }

  private static String read(String host) {
    return LocalToken.read(host, PORT).map(String::new).orElse("none");
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
    assertThat(LocalToken.file(address, PORT).getFileName()).hasToString(name);
    assertThat(LocalToken.file(address, PORT).getParent()).isEqualTo(file.getParent());
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
    Path other = LocalToken.file("boat.lan", PORT);
    write("secret");
    Files.copy(file, other);
    try {
      assertThat(read("boat.lan")).isEqualTo("none");
    } finally {
      Files.delete(other);
    }
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
}
