package org.u2sa.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Programs in benchmarks and scripts that no module compiles; commands compile them when run. */
class LooseSourcesTest {
  private static final Path ROOT = Path.of("").toAbsolutePath().getParent();

  @TempDir private Path classes;

  @Test
  void sources_ofBenchmarksAndScripts_compile() throws IOException {
    List<Path> sources = sources();
    assertThat(sources).hasSizeGreaterThan(15);

    assertThat(compile(sources)).isEmpty();
  }

  @Test
  void compile_sourceWithAnUnknownClass_namesIt() throws IOException {
    Path source = classes.resolve("Broken.java");
    Files.writeString(source, "class Broken { org.u2sa.world.Moved moved; }");

    assertThat(compile(List.of(source))).contains("org.u2sa.world");
  }

  /** Those of the application's proof need Android's library; the application's test runs them. */
  private static List<Path> sources() throws IOException {
    try (Stream<Path> benchmarks = Files.list(ROOT.resolve("benchmarks"));
        Stream<Path> scripts = Files.walk(ROOT.resolve("scripts"))) {
      return Stream.concat(benchmarks, scripts)
          .filter(file -> file.toString().endsWith(".java"))
          .filter(file -> !file.startsWith(ROOT.resolve("scripts/android")))
          .sorted()
          .toList();
    }
  }

  /** Compiles; returns the compiler's messages, empty if there are none. */
  private String compile(List<Path> sources) throws IOException {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    StringWriter said = new StringWriter();
    try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null)) {
      List<String> options =
          List.of(
              "-proc:none",
              "-nowarn",
              "-d",
              classes.toString(),
              "-cp",
              System.getProperty("java.class.path"));
      boolean isCompiled =
          compiler
              .getTask(said, files, null, options, null, files.getJavaFileObjectsFromPaths(sources))
              .call();
      return isCompiled ? "" : said.toString();
    }
  }
}
