package org.u2sa.build;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** What the tests of all modules rely on and only one of the two builds provides. */
final class TestFiles {
  private static final String SETTINGS = "src/test/resources/junit-platform.properties";

  /** Maven's folder of what it made, as a path in a text; Gradle makes build. */
  private static final Pattern FOLDER =
      Pattern.compile(
          "\\b(?:of|get|resolve|resolveSibling)\\(\"target\"|(?<![\\w/.-])target/(?:[\\w$-]|\"|$)",
          Pattern.MULTILINE);

  /** System properties that only Surefire or only Gradle's workers set. */
  private static final Pattern PROPERTY =
      Pattern.compile(
          "getProperty\\(\\s*(\"(?:surefire\\.[\\w.]+|basedir|maven\\.[\\w.]+|org\\.gradle\\.[\\w.]+)\")");

  private TestFiles() {}

  /** One line for each. */
  static List<String> ofOneBuildOnly(Path root) throws IOException {
    List<String> found = new ArrayList<>();
    try (DirectoryStream<Path> modules = Files.newDirectoryStream(root, "u2sa-*")) {
      for (Path module : modules) {
        if (Files.isDirectory(module.resolve("src/test"))) {
          settings(module, found);
        }
        for (String folder : List.of("src/test", "src/testFixtures")) {
          sources(root, module.resolve(folder), found);
        }
      }
    }
    return found;
  }

  /** jqwik's record of earlier runs would go to a folder that may not be there. */
  private static void settings(Path module, List<String> found) throws IOException {
    Properties settings = new Properties();
    Path file = module.resolve(SETTINGS);
    if (Files.exists(file)) {
      settings.load(Files.newBufferedReader(file));
    }
    if (!settings.getProperty("jqwik.database", "absent").isEmpty()) {
      found.add(module.getFileName() + "/" + SETTINGS + ": jqwik.database is not empty");
    }
  }

  private static void sources(Path root, Path folder, List<String> found) throws IOException {
    if (!Files.isDirectory(folder)) {
      return;
    }
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.filter(TestFiles::isText).sorted().toList()) {
        String text = Files.readString(file, StandardCharsets.UTF_8);
        Matcher property = PROPERTY.matcher(text);
        if (property.find()) {
          found.add(root.relativize(file) + ": only one build sets " + property.group(1));
        }
        boolean makesIt = text.contains("createDirectories") || text.contains("isDirectory");
        if (FOLDER.matcher(text).find() && !makesIt) {
          found.add(root.relativize(file) + ": only Maven makes target");
        }
      }
    }
  }

  private static boolean isText(Path file) {
    String name = file.toString();
    return Files.isRegularFile(file)
        && (name.endsWith(".java") || name.endsWith(".kt") || name.endsWith(".properties"))
        && !file.getFileName().toString().startsWith("TestFiles"); // speaks of all that
  }
}
