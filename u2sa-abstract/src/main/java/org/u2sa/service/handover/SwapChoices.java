package org.u2sa.service.handover;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.net.URL;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * Classes of this process that can replace a running service, by role: the lines {@code ROLE CLASS}
 * of each file {@value #FILE} on the class path. A class not listed there can still be swapped in
 * by name.
 */
public final class SwapChoices {
  /** One such file per jar; # starts a comment. */
  static final String FILE = "META-INF/u2sa/services";

  private static final List<String> LINES = read(SwapChoices.class.getClassLoader());

  private SwapChoices() {}

  /**
   * Full names of the classes of a role, in alphabetical order.
   *
   * @param role name of a constant of ServiceRole
   */
  public static List<String> ofRole(String role) {
    Set<String> names = new TreeSet<>();
    for (String line : LINES) {
      if (line.startsWith(role + " ")) {
        names.add(line.substring(role.length() + 1).trim());
      }
    }
    return new ArrayList<>(names);
  }

  private static List<String> read(ClassLoader loader) {
    List<String> lines = new ArrayList<>();
    try {
      for (URL file : Collections.list(loader.getResources(FILE))) {
        try (BufferedReader in =
            new BufferedReader(new InputStreamReader(file.openStream(), UTF_8))) {
          in.lines().filter(line -> !line.startsWith("#")).forEach(lines::add);
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(FILE + " cannot be read", e);
    }
    return lines;
  }
}
