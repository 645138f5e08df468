package org.u2sa.docs;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * All Java and Kotlin files of the repository by class name: tests of other modules are on no class
 * path.
 */
final class SourceFiles {
  private final Map<String, Path> files = new HashMap<>();

  SourceFiles() throws IOException {
    try (Stream<Path> modules = Files.list(Page.ROOT)) {
      for (Path module : modules.toList()) {
        for (String kind : List.of("main", "test", "testFixtures")) {
          add(module.resolve("src").resolve(kind).resolve("java"), ".java");
        }
        for (String kind : List.of("main", "test", "robolectric")) {
          add(module.resolve("src").resolve(kind).resolve("kotlin"), ".kt");
        }
      }
    }
  }

  private void add(Path folder, String ending) throws IOException {
    if (!Files.isDirectory(folder)) {
      return;
    }
    try (Stream<Path> found = Files.walk(folder)) {
      found
          .filter(file -> file.toString().endsWith(ending))
          .forEach(file -> files.put(file.getFileName().toString().replace(ending, ""), file));
    }
  }

  boolean has(String className) {
    return files.containsKey(className);
  }

  /** Whether the class's file has a method of that name. */
  boolean hasMethod(String className, String method) throws IOException {
    return has(className)
        && Files.readString(files.get(className)).matches("(?s).*\\b" + method + "\\s*\\(.*");
  }

  /** The class, if it is on the class path. */
  Optional<Class<?>> load(String className) {
    Path file = files.get(className);
    if (file == null || file.toString().endsWith(".kt")) {
      return Optional.empty();
    }
    String path = file.toString().replace('\\', '/').replace('/', '.');
    String name = path.substring(path.indexOf(".java.") + ".java.".length(), path.length() - 5);
    try {
      return Optional.of(Class.forName(name));
    } catch (ClassNotFoundException e) {
      return Optional.empty();
    }
  }
}
