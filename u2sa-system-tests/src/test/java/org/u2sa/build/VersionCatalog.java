package org.u2sa.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The part of TOML that gradle/libs.versions.toml keeps to, one entry a line. Anything else is
 * refused.
 */
final class VersionCatalog {
  /** What an alias stands for; module is group:artifact. */
  record Library(String module, String version) {}

  private static final Pattern SECTION = Pattern.compile("\\[(versions|libraries|bundles)]");
  private static final Pattern VERSION = Pattern.compile("([\\w-]+) = \"([^\"]+)\"");
  private static final Pattern LIBRARY =
      Pattern.compile("([\\w-]+) = \\{ module = \"([^\"]+)\", version\\.ref = \"([\\w-]+)\" }");
  private static final Pattern BUNDLE = Pattern.compile("([\\w-]+) = \\[([^\\]]*)]");

  private final Map<String, String> versions = new HashMap<>();
  private final Map<String, Library> libraries = new TreeMap<>();
  private final Map<String, List<String>> bundles = new HashMap<>();

  private VersionCatalog() {}

  static VersionCatalog read(Path file) throws IOException {
    VersionCatalog catalog = new VersionCatalog();
    String section = "";
    List<String> lines = Files.readAllLines(file);
    for (int i = 0; i < lines.size(); i++) {
      String line = lines.get(i).trim();
      Matcher header = SECTION.matcher(line);
      if (header.matches()) {
        section = header.group(1);
      } else if (!line.isEmpty() && !line.startsWith("#") && !catalog.accept(section, line)) {
        throw new IllegalStateException(
            file + ", line " + (i + 1) + ": \"" + line + "\" is no entry of [" + section + "]");
      }
    }
    return catalog;
  }

  private boolean accept(String section, String line) {
    Pattern pattern =
        switch (section) {
          case "versions" -> VERSION;
          case "libraries" -> LIBRARY;
          default -> BUNDLE;
        };
    Matcher entry = pattern.matcher(line);
    if (!entry.matches()) {
      return false;
    }
    switch (section) {
      case "versions" -> versions.put(entry.group(1), entry.group(2));
      case "libraries" ->
          libraries.put(entry.group(1), new Library(entry.group(2), version(entry.group(3))));
      default ->
          bundles.put(entry.group(1), List.of(entry.group(2).replace("\"", "").split("\\s*,\\s*")));
    }
    return true;
  }

  private String version(String reference) {
    return Optional.ofNullable(versions.get(reference))
        .orElseThrow(() -> new IllegalStateException("no version \"" + reference + "\""));
  }

  Map<String, Library> libraries() {
    return libraries;
  }

  /** By alias as a script spells it, with dots, or as the catalog does, with hyphens. */
  Library library(String alias) {
    return Optional.ofNullable(libraries.get(alias.replace('.', '-')))
        .orElseThrow(() -> new IllegalStateException("the catalog has no library " + alias));
  }

  List<String> bundle(String name) {
    return Optional.ofNullable(bundles.get(name))
        .orElseThrow(() -> new IllegalStateException("the catalog has no bundle " + name));
  }
}
