package org.u2sa.spark;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.interfaces.BadInputException;

/**
 * A Spark installation.
 *
 * @param jars library folder
 * @param version such as 4.1.0
 */
record SparkHome(Path jars, String version) {
  /** Environment variable with the installation folder. */
  static final String VARIABLE = "SPARK_HOME";

  private static final Pattern CORE = Pattern.compile("spark-core_(2\\.\\d+)-(\\d.*)\\.jar");
  private static final String SCALA = "2.13";

  /**
   * @param folder value of {@link #VARIABLE}; null if not set
   * @throws BadInputException if it contains no supported Spark
   */
  static SparkHome of(String folder) {
    if (folder == null || folder.isBlank()) {
      throw refused("is not set");
    }
    Path jars = Path.of(folder, "jars");
    if (!Files.isDirectory(jars)) {
      throw refused("is \"" + folder + "\", which has no folder jars");
    }
    try (DirectoryStream<Path> found = Files.newDirectoryStream(jars, "spark-core_*.jar")) {
      for (Path jar : found) {
        Matcher core = CORE.matcher(jar.getFileName().toString());
        if (core.matches() && core.group(1).equals(SCALA)) {
          return new SparkHome(jars.toAbsolutePath(), core.group(2));
        }
        throw refused("is \"" + folder + "\", which has " + jar.getFileName());
      }
    } catch (IOException e) {
      throw refused("is \"" + folder + "\", which cannot be read: " + e.getMessage());
    }
    throw refused("is \"" + folder + "\", which has no jars/spark-core_" + SCALA + "-*.jar");
  }

  private static BadInputException refused(String why) {
    return new BadInputException(
        "--master needs Apache Spark, but "
            + VARIABLE
            + " "
            + why
            + "; expected the folder of a Spark 4 for Scala "
            + SCALA
            + ": scripts/spark/install DIR creates one (docs/campaigns.md)");
  }
}
