package org.u2sa.build;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reads what Gradle reads: settings, version catalog, convention plugin and each module's script.
 */
final class GradleBuild {
  private static final String BOM = "u2sa-bom";
  private static final Pattern INCLUDE = Pattern.compile("\\s*include\\(\"([^\"]+)\"\\)");
  private static final Pattern TEXT = Pattern.compile("\"([^\"]*)\"");

  private static final Pattern TEST_KITS = Pattern.compile("val testKits = listOf\\(([^)]*)\\)");

  private static final Pattern TEST_PROPERTY =
      Pattern.compile("\\bit\\.systemProperty\\(\"([^\"]+)\", \"([^\"]*)\"\\)");

  private GradleBuild() {}

  static BuildDescription read(Path folder) throws IOException {
    Properties properties = new Properties();
    try (Reader reader = Files.newBufferedReader(folder.resolve("gradle.properties"))) {
      properties.load(reader);
    }
    String group = properties.getProperty("group");
    String version = properties.getProperty("version");
    VersionCatalog catalog = VersionCatalog.read(folder.resolve("gradle/libs.versions.toml"));

    SortedMap<String, SortedSet<Dependency>> modules = new TreeMap<>();
    SortedSet<String> bom = new TreeSet<>();
    SortedMap<String, String> settings = settings(folder, group, version);
    for (String line : Files.readAllLines(folder.resolve("settings.gradle.kts"))) {
      Matcher include = INCLUDE.matcher(line);
      if (include.matches()) {
        String module = include.group(1);
        Path script = folder.resolve(module).resolve("build.gradle.kts");
        SortedSet<Dependency> own = new DependencyBlock(script, group, version, catalog).read();
        if (module.equals(BOM)) {
          own.forEach(dependency -> bom.add(dependency.name().substring(group.length() + 1)));
          bom.addAll(testKits(script));
          own = new TreeSet<>();
        }
        modules.put(module, own);
        Matcher property = TEST_PROPERTY.matcher(Files.readString(script));
        while (property.find()) {
          settings.put("test property of " + module + ", " + property.group(1), property.group(2));
        }
      }
    }
    return new BuildDescription(settings, managed(catalog), bom, everywhere(catalog), modules);
  }

  /** The test kits that the BOM's script adds to its POM, as Maven would list them. */
  private static SortedSet<String> testKits(Path script) throws IOException {
    String text = Files.readString(script);
    SortedSet<String> listed = new TreeSet<>();
    Matcher list = TEST_KITS.matcher(text);
    if (list.find()) {
      Matcher module = TEXT.matcher(list.group(1));
      String suffix = ":" + written(text, "type") + ":" + written(text, "classifier");
      while (module.find()) {
        listed.add(module.group(1) + suffix);
      }
    }
    return listed;
  }

  private static String written(String script, String element) {
    Matcher matcher = Pattern.compile("\"" + element + "\" to \"([^\"]+)\"").matcher(script);
    return matcher.find() ? matcher.group(1) : "nothing";
  }

  private static SortedMap<String, String> settings(Path folder, String group, String version)
      throws IOException {
    Path plugin =
        folder.resolve("build-logic/src/main/java/org/u2sa/build/JavaConventionsPlugin.java");
    String source = Files.readString(plugin);
    SortedSet<String> arguments = new TreeSet<>();
    Matcher argument = TEXT.matcher(constant(source, "COMPILER_ARGUMENTS"));
    while (argument.find()) {
      arguments.add(argument.group(1));
    }
    SortedSet<String> testClasses = new TreeSet<>();
    Matcher testClass = TEXT.matcher(constant(source, "TEST_CLASSES"));
    while (testClass.find()) {
      testClasses.add(testClass.group(1));
    }
    SortedMap<String, String> settings = new TreeMap<>();
    settings.put("test classes", testClasses.toString());
    settings.put("test JVM", constant(source, "TEST_JVM").replace("\"", ""));
    settings.put("group", group);
    settings.put("version", version);
    settings.put("Java release", constant(source, "JAVA_RELEASE"));
    settings.put("excluded tags", constant(source, "EXCLUDED_TAGS").replace("\"", ""));
    settings.put("compiler arguments", arguments.toString());
    return settings;
  }

  private static String constant(String source, String name) {
    Matcher matcher = Pattern.compile(name + "\\s*=\\s*([^;]+);").matcher(source);
    if (!matcher.find()) {
      throw new IllegalStateException("JavaConventionsPlugin has no constant " + name);
    }
    return matcher.group(1);
  }

  private static SortedMap<String, String> managed(VersionCatalog catalog) {
    SortedMap<String, String> managed = new TreeMap<>();
    for (Map.Entry<String, VersionCatalog.Library> entry : catalog.libraries().entrySet()) {
      VersionCatalog.Library library = entry.getValue();
      managed.put(library.module(), library.version());
    }
    return managed;
  }

  private static SortedSet<Dependency> everywhere(VersionCatalog catalog) {
    SortedSet<Dependency> everywhere = new TreeSet<>();
    for (String alias : catalog.bundle("test")) {
      VersionCatalog.Library library = catalog.library(alias);
      everywhere.add(
          new Dependency(
              library.module(), library.version(), Dependency.Scope.TEST, new TreeSet<>()));
    }
    return everywhere;
  }
}
