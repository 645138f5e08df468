package org.u2sa.core.communication.access;

import java.security.SecureRandom;
import java.util.Base64;
import java.util.EnumSet;
import java.util.List;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.PasswordHash;
import org.u2sa.core.security.User;

/**
 * A user with a generated password that is valid for one run of the broker: for the services of its
 * process and programs of the same account.
 */
public record ProcessAccount(User user, String password) {
  private static final int PASSWORD_BYTES = 32;
  // The password is long and random, so guesses need not be made costly.
  private static final int ITERATIONS = 1;

  static ProcessAccount named(String name) {
    return with(name, EnumSet.allOf(AccessRole.class));
  }

  /** Creates an account with a random name. */
  public static ProcessAccount unnamed() {
    return named("process-" + random());
  }

  static ProcessAccount with(String name, EnumSet<AccessRole> roles) {
    String password = random();
    PasswordHash hash = PasswordHash.of(password.toCharArray(), new SecureRandom(), ITERATIONS);
    return new ProcessAccount(new User(name, roles, List.of(User.EVERY_SYSTEM), hash), password);
  }

  private static String random() {
    byte[] bytes = new byte[PASSWORD_BYTES];
    new SecureRandom().nextBytes(bytes);
    return Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
  }

  @Override
  public String toString() {
    return user.name(); // never the password
  }
}
