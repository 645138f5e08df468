package org.u2sa.testkit;

import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.opentest4j.TestAbortedException;

/**
 * Programs that are not Java's, on the path or where Debian puts what only root's path has. A test
 * says what it needs by {@link NeedsProgram}, and gets it by {@link #required}.
 */
public final class ForeignPrograms {
  private final List<String> folders = new ArrayList<>();
  private final boolean ci;
  private final PrintStream out;

  /**
   * @param out takes one line for each test that is skipped
   * @param environment PATH and CI
   * @param further folders that are looked through after the path's
   */
  ForeignPrograms(PrintStream out, Map<String, String> environment, String... further) {
    this.out = out;
    for (String folder : environment.getOrDefault("PATH", "").split(File.pathSeparator)) {
      if (!folder.isEmpty()) {
        folders.add(folder);
      }
    }
    folders.addAll(List.of(further));
    ci = "true".equals(environment.get("CI"));
  }

  /** Those of this machine. */
  public static ForeignPrograms ofThisMachine() {
    return new ForeignPrograms(System.out, System.getenv(), "/usr/bin", "/usr/sbin");
  }

  /**
   * Where a program is.
   *
   * @param name without folders
   * @param pythonModules what it must be able to import, if it is a Python
   * @throws TestAbortedException if it is missing: the test is skipped
   * @throws AssertionError if it is missing and {@code CI=true}
   */
  public String required(String name, String... pythonModules) {
    Optional<String> missing = missing(name, pythonModules);
    if (missing.isPresent()) {
      skipped("A test", missing.get());
      throw new TestAbortedException(missing.get());
    }
    return find(name, pythonModules).orElseThrow();
  }

  /**
   * What to say of a program that is missing; empty if it is here.
   *
   * @throws AssertionError if it is missing and {@code CI=true}
   */
  Optional<String> missing(String name, String... pythonModules) {
    if (find(name, pythonModules).isPresent()) {
      return Optional.empty();
    }
    String with = pythonModules.length == 0 ? "" : " with " + String.join(", ", pythonModules);
    String words = name + with + " is not here (docs/testing.md)";
    if (ci) {
      throw new AssertionError(words + ", and CI=true skips nothing");
    }
    return Optional.of(words);
  }

  void skipped(String test, String reason) {
    out.println(test + " is skipped: " + reason);
  }

  private Optional<String> find(String name, String... pythonModules) {
    return folders.stream()
        .map(folder -> Path.of(folder, name))
        .filter(Files::isExecutable)
        .map(Path::toString)
        .filter(program -> pythonModules.length == 0 || imports(program, pythonModules))
        .findFirst();
  }

  private static boolean imports(String python, String... modules) {
    try {
      Process process =
          new ProcessBuilder(python, "-c", "import " + String.join(", ", modules))
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .start();
      return process.waitFor() == 0;
    } catch (IOException e) {
      return false; // no program after all, such as a script for an interpreter that is not here
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("interrupted while looking for " + python, e);
    }
  }
}
