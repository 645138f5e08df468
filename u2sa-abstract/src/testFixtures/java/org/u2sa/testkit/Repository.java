package org.u2sa.testkit;

import java.nio.file.Files;
import java.nio.file.Path;

/** The folder that holds {@code config}, {@code missions} and {@code scripts}. */
public final class Repository {
  private Repository() {}

  /**
   * Searches upwards from the working directory, because a test runs in its module's folder.
   *
   * @throws IllegalStateException if it is not inside the repository
   */
  public static Path root() {
    for (Path at = Path.of("").toAbsolutePath(); at != null; at = at.getParent()) {
      if (Files.isDirectory(at.resolve("config/cessna"))) {
        return at;
      }
    }
    throw new IllegalStateException("there is no config/cessna above the working directory");
  }
}
