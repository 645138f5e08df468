package org.u2sa.cli.dependencies;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The list is the build's, and no version in it is known to be weak where we use it. */
class DependencyDataTest {
  private static final Path ROOT = Path.of("").toAbsolutePath().getParent();

  /** Brought by whoever runs the tests, Surefire or Gradle. */
  private static final Pattern RUNNER =
      Pattern.compile("(surefire|common-java5|gradle|junit-platform-launcher).*");

  private final DependencyData data = DependencyData.inThisJar();

  @Test
  void libraries_classPathOfThisModule_isListedVersionByVersion() {
    List<String> listed =
        data.libraries().stream()
            .map(each -> each.name().replaceFirst(".*:", "") + "-" + each.version())
            .toList();
    List<String> used =
        Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
            .map(path -> Path.of(path).getFileName().toString())
            .filter(name -> name.endsWith(".jar") && !name.startsWith("u2sa-"))
            .map(name -> name.substring(0, name.length() - ".jar".length()))
            .filter(name -> !RUNNER.matcher(name).matches())
            .toList();

    assertThat(used).isNotEmpty();
    assertThat(listed).as("libraries.txt").containsAll(used);
  }

  @Test
  void libraries_versionsOfTheRootPom_areTheSame() throws IOException {
    String pom = Files.readString(ROOT.resolve("pom.xml"));
    Matcher managed =
        Pattern.compile(
                "<dependency>\\s*<groupId>([^<]+)</groupId>\\s*<artifactId>([^<]+)</artifactId>"
                    + "\\s*<version>\\$\\{([\\w.-]+)}</version>")
            .matcher(pom);
    int seen = 0;
    while (managed.find()) {
      String name = managed.group(1) + ":" + managed.group(2);
      if (!name.startsWith("org.u2sa:")) {
        seen++;
        assertThat(pom).as(name).contains("<" + managed.group(3) + ">" + version(name) + "<");
      }
    }
    assertThat(seen).isGreaterThan(20);
  }

  private String version(String name) {
    return data.libraries().stream()
        .filter(each -> each.name().equals(name))
        .map(DependencyData.Library::version)
        .findFirst()
        .orElseThrow(() -> new AssertionError("libraries.txt has no " + name));
  }

  @Test
  void advisories_ourVersions_fallIntoNoRange() {
    assertThat(data.libraries())
        .allSatisfy(
            library ->
                assertThat(data.affecting(library))
                    .as(library.name() + " " + library.version() + ": take a fixed version")
                    .isEmpty());
  }

  @Test
  void advisories_versionsOfBefore_areFound() {
    DependencyData.Library old =
        new DependencyData.Library(
            "io.netty:netty-codec-mqtt", "4.1.93.Final", data.lookedUp(), "run", "Apache-2.0");

    assertThat(data.affecting(old))
        .extracting(DependencyData.Advisory::id)
        .contains("CVE-2026-44248");
  }
}
