package org.u2sa.spark;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;

/**
 * Spark's own file of settings, which its masters and workers read as well: the place for a
 * cluster's secret, since every account of a host can read a process's command line. Used by the
 * driver too, which has few of our classes.
 */
final class ClusterProperties {
  private static final String FILE = "spark-defaults.conf";

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
}
