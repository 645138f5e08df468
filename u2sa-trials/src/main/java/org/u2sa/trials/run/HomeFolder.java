package org.u2sa.trials.run;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.u2sa.interfaces.BadInputException;

/** Location of U2SA's files. */
public final class HomeFolder {
  private static final String PROPERTY = "u2sa.home";

  private HomeFolder() {}

  /** JVM options with which a child process finds the same files. */
  public static List<String> javaOptions() {
    String home = System.getProperty(PROPERTY);
    return home == null ? List.of() : List.of("-D" + PROPERTY + "=" + home);
  }

  /** Set by the launcher, or the current folder. */
  public static Path path() {
    return Path.of(System.getProperty(PROPERTY, ""));
  }

  /**
   * The folder containing {@code config} and {@code missions}: set by the launcher, or the current
   * folder.
   *
   * @param folder required subfolder, e.g. {@code config/ugv}
   * @throws BadInputException if that is missing
   */
  public static Path holding(String folder) {
    Path home = path();
    if (!Files.isDirectory(home.resolve(folder))) {
      throw new BadInputException(
          "there is no "
              + folder
              + " in "
              + home.toAbsolutePath()
              + "; run ./u2sa, or set -D"
              + PROPERTY
              + " to its folder");
    }
    return home;
  }
}
