package org.u2sa.cli.template;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.interfaces.BadInputException;

/** Build tool of a project. */
enum BuildTool {
  MAVEN(
      "pom.xml", "<groupId>\\s*([^<\\s]+)", "mvn -q install -DskipTests", "mvn verify", "target/*"),
  GRADLE(
      "build.gradle.kts",
      "(?m)^group\\s*=\\s*\"([^\"]+)\"",
      "./gradlew publishToMavenLocal",
      "./gradlew build",
      "build/libs/*");

  private final String file;
  private final Pattern group;

  /** Command, run in U2SA's folder, that installs U2SA for this tool. */
  final String install;

  final String build;

  /** Folder of the built jars. */
  final String jars;

  BuildTool(String file, String group, String install, String build, String jars) {
    this.file = file;
    this.group = Pattern.compile(group);
    this.install = install;
    this.build = build;
    this.jars = jars;
  }

  /** Template with this tool's project files. */
  String template() {
    return name().toLowerCase(Locale.ROOT);
  }

  static Optional<BuildTool> in(Path folder) {
    return Arrays.stream(values())
        .filter(tool -> Files.isRegularFile(folder.resolve(tool.file)))
        .findFirst();
  }

  /** Whether the project in the folder takes U2SA's versions from its BOM. */
  boolean usesU2sa(Path folder) {
    return Pattern.compile("<artifactId>u2sa-bom<|org\\.u2sa:u2sa-bom:")
        .matcher(text(folder))
        .find();
  }

  Optional<String> group(Path folder) {
    Matcher matcher = group.matcher(text(folder));
    return matcher.find() ? Optional.of(matcher.group(1)) : Optional.empty();
  }

  private String text(Path folder) {
    try {
      return Files.readString(folder.resolve(file));
    } catch (IOException e) {
      throw new BadInputException(folder.resolve(file) + ": " + e.getMessage(), e);
    }
  }
}
