package org.u2sa.spark;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ProgramArchiveTest {
  @TempDir private Path folder;

  private Path file(String name) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    return Files.writeString(file, name);
  }

  @Test
  void write_classPathAndHome_areInItInOrder() throws IOException {
    Path jar = file("libraries/z.jar");
    Path classes = file("classes/org/A.class").getParent().getParent();
    file("home/config/ugv/system.xml");
    file("home/out/track.csv");
    Path archive = folder.resolve("program.zip");

    ProgramArchive.write(
        archive,
        String.join(File.pathSeparator, jar.toString(), folder + "/absent.jar", classes.toString()),
        folder.resolve("home"));

    try (ZipFile zip = new ZipFile(archive.toFile())) {
      assertThat(zip.stream().map(entry -> entry.getName()))
          .containsExactly("lib/000-z.jar", "lib/002-classes/org/A.class", "config/ugv/system.xml");
      assertThat(zip.getInputStream(zip.getEntry("lib/000-z.jar"))).hasContent("libraries/z.jar");
    }
  }

  @Test
  void jarOf_classInAFolder_isMade() throws IOException {
    Path jar = ProgramArchive.jarOf(SparkDriver.class, folder);

    try (ZipFile zip = new ZipFile(jar.toFile())) {
      assertThat(zip.getEntry("org/u2sa/spark/SparkDriver.class")).isNotNull();
    }
  }
}
