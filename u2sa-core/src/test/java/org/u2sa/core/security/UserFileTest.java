package org.u2sa.core.security;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;

class UserFileTest {
  private static final int FEW = 1_000; // iterations: a test need not resist anybody
  private static final PasswordHash HASH =
      PasswordHash.of("secret".toCharArray(), new SecureRandom(), FEW);

  @TempDir Path folder;

  private static User user(String name, AccessRole role, String system) {
    return new User(name, EnumSet.of(role), List.of(system), HASH);
  }

  @Test
  void read_ofWrite_givesTheSameUsersAndTheirPasswords() {
    Path file = folder.resolve("users.txt");
    UserFile.write(
        file,
        List.of(user("pilot", AccessRole.OPERATOR, "cessna"), user("x", AccessRole.SAFETY, "*")));

    assertThat(UserFile.read(file).keySet()).containsExactly("pilot", "x");
    User read = UserFile.read(file).get("pilot");
    assertThat(read.roles()).containsExactly(AccessRole.OPERATOR);
    assertThat(read.systems()).containsExactly("cessna");
    assertThat(read.password().matches("secret".toCharArray())).isTrue();
    assertThat(read.password().matches("Secret".toCharArray())).isFalse();
  }

  @Test
  void read_twice_givesEqualUsers() {
    Path file = folder.resolve("users.txt");
    UserFile.write(file, List.of(user("pilot", AccessRole.OPERATOR, "cessna")));

    assertThat(UserFile.read(file)).isEqualTo(UserFile.read(file)).hasSize(1);
    assertThat(UserFile.read(file).get("pilot").password())
        .isNotEqualTo(PasswordHash.of("secret".toCharArray(), new SecureRandom(), FEW))
        .hasSameHashCodeAs(HASH);
  }

  @Test
  void write_anyUmask_onlyTheOwnerMayRead() throws IOException {
    Path file = folder.resolve("users.txt");
    UserFile.write(file, List.of());

    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
        .isEqualTo("rw-------");
    assertThat(SecretFile.tooOpen(file)).isEmpty();
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r-----"));
    assertThat(SecretFile.tooOpen(file)).get().asString().contains("chmod 600");
  }

  @Test
  void of_samePasswordTwice_looksDifferent() {
    assertThat(PasswordHash.of("secret".toCharArray(), new SecureRandom(), FEW).toString())
        .isNotEqualTo(HASH.toString())
        .doesNotContain("secret");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "pilot:operator:cessna | expected name:roles:systems:password",
        "pilot:captain:cessna:x | role \"captain\"",
        "p/q:operator:cessna:x | pbkdf2-sha512$",
        "pilot::cessna:%s | at least one role",
        "pilot:operator:ces/na:%s | system ID \"ces/na\"",
        "pilot:operator:cessna:pbkdf2-sha512$0$AA==$AA== | iterations"
      })
  void read_wrongLine_namesFileLineAndWhatWasExpected(String line, String expected)
      throws IOException {
    Path file = folder.resolve("users.txt");
    Files.writeString(file, "# users\n" + line.replace("%s", HASH.toString()) + "\n");

    assertThatThrownBy(() -> UserFile.read(file))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("users.txt, line 2")
        .hasMessageContaining(expected);
  }

  @Test
  void read_missingFile_saysWhatMakesOne() {
    assertThatThrownBy(() -> UserFile.read(folder.resolve("none.txt")))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("none.txt")
        .hasMessageContaining("u2sa security init");
  }

  @Test
  void read_userTwice_isRefused() throws IOException {
    Path file = folder.resolve("users.txt");
    String line = user("pilot", AccessRole.OPERATOR, "cessna").line();
    Files.writeString(file, line + "\n\n" + line + "\n");

    assertThatThrownBy(() -> UserFile.read(file))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("users.txt, line 3: user \"pilot\" is listed twice");
  }

  @Test
  void read_whatIsNoUsersFile_isSaid() throws IOException {
    Path file = folder.resolve("users.txt");
    byte[] largest = new byte[1 << 20];
    Arrays.fill(largest, (byte) '\n');
    Files.write(file, largest);
    assertThat(UserFile.read(file)).isEmpty();

    Files.write(file, Arrays.copyOf(largest, largest.length + 1));
    assertThatThrownBy(() -> UserFile.read(file))
        .hasMessageContaining("users.txt: larger than 1048576 bytes");
    assertThatThrownBy(() -> UserFile.read(folder))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining(folder + ": cannot be read");
  }

  @Test
  void mayEnter_otherSystem_isRefused() {
    assertThat(user("a", AccessRole.OPERATOR, "cessna").mayEnter("cessna")).isTrue();
    assertThat(user("a", AccessRole.OPERATOR, "boat").mayEnter("cessna")).isFalse();
    assertThat(user("a", AccessRole.OPERATOR, "*").mayEnter("cessna")).isTrue();
  }
}
