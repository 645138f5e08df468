package org.u2sa.gcs.security;

import java.io.Console;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import org.u2sa.core.security.SecretFile;
import org.u2sa.interfaces.BadInputException;

/** Where a user's password comes from: never from the command line, which every process can see. */
final class Passwords {
  private static final int SHORTEST = 10;
  private static final int RANDOM_BYTES = 24;

  private Passwords() {}

  /** The first line of a file. */
  static char[] read(Path file) {
    requireClosed("--password-file", file);
    try {
      List<String> lines = Files.readAllLines(file, StandardCharsets.UTF_8);
      return checked(lines.isEmpty() ? new char[0] : lines.get(0).toCharArray(), file.toString());
    } catch (IOException e) {
      throw new BadInputException("--password-file " + file + ": cannot be read: " + e, e);
    }
  }

  private static void requireClosed(String option, Path file) {
    if (Files.exists(file) && !Files.isRegularFile(file)) {
      throw new BadInputException(option + " " + file + ": is not a regular file");
    }
    if (Files.exists(file)) {
      SecretFile.tooOpen(file)
          .ifPresent(
              what -> {
                throw new BadInputException(option + " " + what);
              });
    }
  }

  /** A random one; nobody need remember it. */
  static char[] make(Path newFile) {
    if (Files.exists(newFile)) {
      throw new BadInputException(
          "--new-password-file " + newFile + ": is there already; it is not overwritten");
    }
    byte[] random = new byte[RANDOM_BYTES];
    new SecureRandom().nextBytes(random);
    return Base64.getUrlEncoder().encodeToString(random).toCharArray();
  }

  /** Asks at the terminal, twice. */
  static char[] ask(String name) {
    Console console = System.console();
    if (console == null) {
      throw new BadInputException(
          "there is no terminal to ask for a password: use --password-file or --new-password-file");
    }
    char[] first = console.readPassword("Password of %s: ", name);
    char[] again = console.readPassword("Again: ");
    if (first == null || !Arrays.equals(first, again)) {
      throw new BadInputException("the two passwords differ; nothing was changed");
    }
    return checked(first, "the password");
  }

  private static char[] checked(char[] password, String where) {
    if (password.length < SHORTEST) {
      throw new BadInputException(
          where + ": " + password.length + " characters; expected " + SHORTEST + " or more");
    }
    return password;
  }
}
