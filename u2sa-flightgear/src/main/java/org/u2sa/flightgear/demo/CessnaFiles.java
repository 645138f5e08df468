package org.u2sa.flightgear.demo;

import java.nio.file.Files;
import java.nio.file.Path;
import org.u2sa.interfaces.BadInputException;

/** Where the Cessna's files lie. */
final class CessnaFiles {
  private static final String ROOT = "u2sa.home";

  private CessnaFiles() {}

  /**
   * The folder that holds {@code config} and {@code missions}: the launcher's, or the current one.
   */
  static Path root() {
    Path root = Path.of(System.getProperty(ROOT, ""));
    if (!Files.isDirectory(root.resolve("config/cessna"))) {
      throw new BadInputException(
          "there is no config/cessna in "
              + root.toAbsolutePath()
              + "; run ./u2sa, or set -D"
              + ROOT
              + " to its folder");
    }
    return root;
  }

  /** A file as the user named it, so that it is found from any directory. */
  static String absolute(String file) {
    return Path.of(file).toAbsolutePath().toString();
  }
}
