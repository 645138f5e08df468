package org.u2sa.core.security;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.u2sa.interfaces.BadInputException;

/**
 * The users' file: one line {@code name:roles:systems:password} per user; lines that start with #
 * are comments.
 */
public final class UserFile {
  private static final int LARGEST = 1 << 20;
  private static final String HEADER =
      "# Users of the Communication Manager: name:roles:systems:password. Written by u2sa security user.";

  private UserFile() {}

  /**
   * Reads the file.
   *
   * @return the users by name
   * @throws BadInputException if it is missing or invalid; names file, line and the expected
   *     content
   */
  public static Map<String, User> read(Path file) {
    Map<String, User> users = new TreeMap<>();
    int number = 0;
    for (String line : lines(file)) {
      number++;
      if (line.trim().isEmpty() || line.startsWith("#")) {
        continue;
      }
      try {
        User user = User.parse(line.trim());
        if (users.put(user.name(), user) != null) {
          throw new IllegalArgumentException("user \"" + user.name() + "\" is listed twice");
        }
      } catch (IllegalArgumentException e) {
        throw new BadInputException(file + ", line " + number + ": " + e.getMessage(), e);
      }
    }
    return Collections.unmodifiableMap(users);
  }

  private static List<String> lines(Path file) {
    try {
      if (Files.size(file) > LARGEST) {
        throw new BadInputException(file + ": larger than " + LARGEST + " bytes; wrong file?");
      }
      return Files.readAllLines(file, StandardCharsets.UTF_8);
    } catch (NoSuchFileException e) {
      throw new BadInputException(file + ": no such file; create it with ./u2sa security init", e);
    } catch (IOException e) {
      throw new BadInputException(file + ": cannot be read: " + e, e);
    }
  }

  /** Writes the users atomically, readable by the file's owner only. */
  public static void write(Path file, Collection<User> users) {
    List<String> lines = new ArrayList<>();
    lines.add(HEADER);
    users.forEach(user -> lines.add(user.line()));
    SecretFile.write(file, (String.join("\n", lines) + "\n").getBytes(StandardCharsets.UTF_8));
  }
}
