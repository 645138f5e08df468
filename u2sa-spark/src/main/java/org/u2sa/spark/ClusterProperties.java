package org.u2sa.spark;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Properties;
import java.util.Set;
import org.u2sa.interfaces.BadInputException;

/**
 * Spark's own file of settings, which its masters and workers read as well: the place for a
 * cluster's secret, since every account of a host can read a process's command line.
 */
final class ClusterProperties {
  private static final String FILE = "spark-defaults.conf";
  private static final Set<PosixFilePermission> OTHERS =
      EnumSet.of(
          PosixFilePermission.GROUP_READ,
          PosixFilePermission.GROUP_WRITE,
          PosixFilePermission.OTHERS_READ,
          PosixFilePermission.OTHERS_WRITE);

  private ClusterProperties() {}

  /**
   * The file's path, existing or not, where Spark looks for it.
   *
   * @param environment with {@code SPARK_CONF_DIR} or {@link SparkHome#VARIABLE}
   */
  static Path file(Map<String, String> environment) {
    String folder = environment.getOrDefault("SPARK_CONF_DIR", "");
    return folder.isEmpty()
        ? Path.of(environment.getOrDefault(SparkHome.VARIABLE, ""), "conf", FILE)
        : Path.of(folder, FILE);
  }

  /**
   * The settings; none if there is no such file.
   *
   * @throws IOException if it cannot be read
   */
  static Properties read(Path file) throws IOException {
    Properties settings = new Properties();
    if (Files.exists(file)) {
      try (Reader in = Files.newBufferedReader(file)) {
        settings.load(in);
      }
    }
    return settings;
  }

  /**
   * Refuses secrets that other accounts of this host can read.
   *
   * @param javaOptions options of this process
   * @throws BadInputException if one is among the options, or in a file that others may access
   */
  static void check(Path file, List<String> javaOptions) {
    for (String option : javaOptions) {
      String name = option.split("=", 2)[0];
      if (name.startsWith("-Dspark.") && isSecret(name)) {
        throw new BadInputException(
            name
                + " in U2SA_JAVA_OPTS: every account of this host can read it; write it into "
                + file
                + " with mode 600 instead, without -D");
      }
    }
    try {
      if (read(file).stringPropertyNames().stream().anyMatch(ClusterProperties::isSecret)
          && isOpen(file)) {
        throw new BadInputException(
            file + " has a secret, and users other than its owner may read it; chmod 600 it");
      }
    } catch (IOException | IllegalArgumentException e) {
      throw new BadInputException(file + " cannot be read: " + e.getMessage(), e);
    }
  }

  private static boolean isSecret(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    return lower.contains("secret") || lower.contains("password");
  }

  private static boolean isOpen(Path file) throws IOException {
    if (!file.getFileSystem().supportedFileAttributeViews().contains("posix")) {
      return false; // non-POSIX permissions, not visible to Java
    }
    return Files.getPosixFilePermissions(file).stream().anyMatch(OTHERS::contains);
  }
}
