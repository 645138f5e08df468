package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.EnumSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.PasswordHash;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.core.security.User;
import org.u2sa.core.security.UserFile;

class BrokerSecurityTest {
  @TempDir private Path folder;

  private static User user(String name, AccessRole role) {
    PasswordHash hash = PasswordHash.of("secret".toCharArray(), new SecureRandom(), 1_000);
    return new User(name, EnumSet.of(role), List.of("rover"), hash);
  }

  /** Each operation of a bridge's client asks, also while the disk hangs. */
  @Test
  void isOperator_usersFileNotReadable_isAnsweredFromMemory() throws Exception {
    SecurityDirectory directory = new SecurityDirectory(folder);
    UserFile.write(
        directory.users(),
        List.of(user("ann", AccessRole.OPERATOR), user("bob", AccessRole.OBSERVER)));
    BrokerSecurity security = new BrokerSecurity(directory, null);
    security.users(line -> {});
    Files.delete(directory.users());

    assertThat(security.isOperator("ann")).isTrue();
    assertThat(security.isOperator("bob")).isFalse();
    assertThat(security.isOperator("")).isFalse();
  }
}
