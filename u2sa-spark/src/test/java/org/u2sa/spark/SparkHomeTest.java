package org.u2sa.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;

class SparkHomeTest {
  @TempDir private Path folder;

  private void jar(String name) throws IOException {
    Files.createDirectories(folder.resolve("jars"));
    Files.createFile(folder.resolve("jars").resolve(name));
  }

  private void assertRefused(String home, String why) {
    assertThatThrownBy(() -> SparkHome.of(home))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("SPARK_HOME " + why)
        .hasMessageContaining("scripts/spark/install");
  }

  @Test
  void of_folderWithSpark_knowsItsVersion() throws IOException {
    jar("spark-core_2.13-4.1.0.jar");
    jar("spark-common-utils_2.13-4.1.0.jar");

    assertThat(SparkHome.of(folder.toString()))
        .isEqualTo(new SparkHome(folder.resolve("jars").toAbsolutePath(), "4.1.0"));
  }

  @Test
  void of_nothing_isRefused() {
    assertRefused(null, "is not set");
    assertRefused(" ", "is not set");
  }

  @Test
  void of_folderWithoutSpark_isRefused() throws IOException {
    assertRefused(folder.toString(), "is \"" + folder + "\", which has no folder jars");
    jar("scala-library-2.13.17.jar");
    assertRefused(folder.toString(), "is \"" + folder + "\", which has no jars/spark-core_2.13");
  }

  @Test
  void of_sparkForAnotherScala_isRefused() throws IOException {
    jar("spark-core_2.12-3.5.0.jar");

    assertRefused(folder.toString(), "is \"" + folder + "\", which has spark-core_2.12-3.5.0.jar");
  }
}
