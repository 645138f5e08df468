package org.u2sa.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that pass in one build pass in the other: neither gives them what the other does not. */
class TestFilesTest {
  @TempDir private Path root;

  @Test
  void tests_asTheyStand_relyOnNeitherBuild() throws IOException {
    assertThat(TestFiles.ofOneBuildOnly(BuildsAgreeTest.ROOT)).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          src/test/resources/junit-platform.properties | jqwik.database = target/jqwik-database            | junit-platform.properties: jqwik.database is not empty
          src/test/resources/junit-platform.properties | jqwik.database = target/jqwik-database            | junit-platform.properties: only Maven makes target
          src/test/resources/junit-platform.properties | # nothing                                         | jqwik.database is not empty
          src/test/java/SomeTest.java                  | Files.writeString(Path.of("target/x.txt"), text); | SomeTest.java: only Maven makes target
          src/test/java/SomeTest.java                  | Files.list(Path.of("target", "classes"));         | SomeTest.java: only Maven makes target
          src/testFixtures/java/Kit.java               | System.getProperty("basedir")                     | Kit.java: only one build sets "basedir"
          src/test/java/SomeTest.java                  | System.getProperty("surefire.test.class.path", "x")      | only one build sets "surefire.test.class.path"
          """)
  void ofOneBuildOnly_fileThatReliesOnIt_isNamed(String file, String text, String expected)
      throws IOException {
    write("src/test/resources/junit-platform.properties", "jqwik.database =");
    assertThat(TestFiles.ofOneBuildOnly(root)).isEmpty();

    write(file, text);

    assertThat(TestFiles.ofOneBuildOnly(root))
        .anySatisfy(line -> assertThat(line).contains(expected));
  }

  @Test
  void ofOneBuildOnly_testThatMakesItsFolder_isLeftAlone() throws IOException {
    write("src/test/resources/junit-platform.properties", "jqwik.database =");
    write("src/test/java/SomeTest.java", "Files.createDirectories(Path.of(\"target\"));");

    assertThat(TestFiles.ofOneBuildOnly(root)).isEmpty();
  }

  private void write(String file, String text) throws IOException {
    Path path = root.resolve("u2sa-some").resolve(file);
    Files.createDirectories(path.getParent());
    Files.writeString(path, text);
  }
}
