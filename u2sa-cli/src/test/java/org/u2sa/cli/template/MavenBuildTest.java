package org.u2sa.cli.template;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.testkit.NeedsProgram;
import picocli.CommandLine;

/** The commands that {@code u2sa new} tells, with Maven itself, without a network. */
@Tag("long")
@NeedsProgram("mvn")
class MavenBuildTest {
  private static final Path ROOT = Path.of("").toAbsolutePath().getParent();

  @TempDir Path folder;

  /**
   * A local repository that has what the user's has, but no U2SA; what is installed there stays
   * there.
   */
  private Path repository() throws IOException, URISyntaxException {
    Path jar =
        Path.of(CommandLine.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    Path users = jar.resolve("../../../../..").normalize(); // group, name, version, jar
    assumeTrue(
        Files.isDirectory(users.resolve("org/apache/maven")),
        jar + " is not in a repository of Maven's: another build runs this test");
    Path ours = Files.createDirectories(folder.resolve("repository/org")).getParent();
    link(users, ours, "org");
    link(users.resolve("org"), ours.resolve("org"), "u2sa");
    return ours;
  }

  private static void link(Path from, Path to, String except) throws IOException {
    try (Stream<Path> children = Files.list(from)) {
      for (Path child : children.toList()) {
        if (!child.getFileName().toString().equals(except)) {
          Files.createSymbolicLink(to.resolve(child.getFileName()), child);
        }
      }
    }
  }

  private void maven(Path directory, Path repository, String... arguments)
      throws IOException, InterruptedException {
    Path output = folder.resolve("maven.txt");
    List<String> command =
        Stream.concat(
                Stream.of("mvn", "-o", "-B", "-q", "-Dmaven.repo.local=" + repository),
                Stream.of(arguments))
            .toList();
    Process process =
        new ProcessBuilder(command)
            .directory(directory.toFile())
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    assertThat(process.waitFor()).as(Files.readString(output)).isZero();
  }

  @Test
  void verify_generatedProject_succeeds() throws Exception {
    Path repository = repository();
    maven(
        ROOT,
        repository,
        "install",
        "-DskipTests",
        "-pl",
        "u2sa-estimation,u2sa-world,u2sa-mission,u2sa-planning,u2sa-control,u2sa-core,u2sa-bom",
        "-am");
    new NewProject(folder).make("vehicle", "boat");
    maven(folder.resolve("boat"), repository, "verify");
    assertThat(folder.resolve("boat/target/boat-1.0.jar")).exists();
    assertThat(folder.resolve("boat/target/surefire-reports")).isNotEmptyDirectory();
  }
}
