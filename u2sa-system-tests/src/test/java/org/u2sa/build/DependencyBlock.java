package org.u2sa.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The dependencies { } of one module's build.gradle.kts, in the few forms that our scripts keep to.
 * A line in another form is refused: what this class cannot read, it could not compare.
 */
final class DependencyBlock {
  private static final Pattern ENTRY =
      Pattern.compile(
          "(\\w+)\\((?:libs\\.([\\w.]+)|(testFixtures\\()?project\\(\":([\\w-]+)\"\\)\\)?)\\)?( \\{)?");
  private static final Pattern EXCLUDE =
      Pattern.compile("exclude\\(group = \"([^\"]+)\"(?:, module = \"([^\"]+)\")?\\)");

  private static final List<String> EVERYWHERE =
      List.of(
          "testImplementation(libs.bundles.test)", "testRuntimeOnly(libs.junit.platform.launcher)");

  private final Path script;
  private final String group;
  private final String version;
  private final VersionCatalog catalog;

  DependencyBlock(Path script, String group, String version, VersionCatalog catalog) {
    this.script = script;
    this.group = group;
    this.version = version;
    this.catalog = catalog;
  }

  SortedSet<Dependency> read() throws IOException {
    SortedSet<Dependency> found = new TreeSet<>();
    List<String> lines = Files.readAllLines(script);
    int line = lines.indexOf("dependencies {") + 1;
    if (line == 0) {
      throw new IllegalStateException(script + " has no line \"dependencies {\"");
    }
    for (; !lines.get(line).equals("}"); line++) {
      String text = lines.get(line).trim();
      Matcher entry = ENTRY.matcher(text);
      if (EVERYWHERE.contains(text)) {
        continue; // where the convention plugin, which adds them, is not applied
      }
      if (entry.matches()) {
        SortedSet<String> exclusions = new TreeSet<>();
        if (entry.group(5) != null) {
          for (line++; !lines.get(line).equals("    }"); line++) {
            exclusions.add(exclusion(lines.get(line).trim(), line));
          }
        }
        found.add(dependency(entry, exclusions, line));
      } else if (!text.isEmpty()
          && !text.startsWith("//")
          && !text.equals("constraints {")
          && !text.equals("}")) {
        throw refused(text, line);
      }
    }
    return found;
  }

  private Dependency dependency(Matcher entry, SortedSet<String> exclusions, int line) {
    Dependency.Scope scope =
        switch (entry.group(1)) {
          case "api" -> Dependency.Scope.COMPILE;
          case "compileOnly" -> Dependency.Scope.PROVIDED;
          case "runtimeOnly" -> Dependency.Scope.RUNTIME;
          case "testImplementation",
                  "testRuntimeOnly",
                  "testFixturesApi",
                  "testFixturesImplementation" ->
              Dependency.Scope.TEST;
          default -> throw refused(entry.group(), line);
        };
    if (entry.group(2) != null) {
      VersionCatalog.Library library = catalog.library(entry.group(2));
      return new Dependency(library.module(), library.version(), scope, exclusions);
    }
    String fixtures = entry.group(3) == null ? "" : ":test-fixtures";
    return new Dependency(group + ":" + entry.group(4) + fixtures, version, scope, exclusions);
  }

  private String exclusion(String text, int line) {
    if (text.equals("isTransitive = false")) {
      return Dependency.EVERYTHING;
    }
    Matcher exclude = EXCLUDE.matcher(text);
    if (!exclude.matches()) {
      throw refused(text, line);
    }
    return exclude.group(1) + (exclude.group(2) == null ? "" : ":" + exclude.group(2));
  }

  private IllegalStateException refused(String text, int line) {
    return new IllegalStateException(
        script + ", line " + (line + 1) + ": \"" + text + "\" is in no form that can be compared");
  }
}
