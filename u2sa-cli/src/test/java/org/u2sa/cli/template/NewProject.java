package org.u2sa.cli.template;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.interfaces.BadInputException;
import picocli.CommandLine;

/** Runs {@code u2sa new} in a folder, and compiles and tests what it made as a build would. */
final class NewProject {
  private final Path here;
  private String told = "";

  /**
   * @param here where the command is run
   */
  NewProject(Path here) {
    this.here = here;
  }

  /**
   * Runs the command.
   *
   * @throws BadInputException what it refuses, which the program answers with exit code 2
   */
  void make(String... args) {
    StringWriter out = new StringWriter();
    CommandLine line = new CommandLine(new NewCommand(here)).setOut(new PrintWriter(out, true));
    AtomicReference<Exception> refusal = new AtomicReference<>();
    line.setExecutionExceptionHandler(
        (e, command, parsed) -> {
          refusal.set(e);
          return ExitCode.BAD_INPUT;
        });
    line.setParameterExceptionHandler(
        (e, command) -> {
          refusal.set(e);
          return ExitCode.BAD_INPUT;
        });
    line.execute(args);
    if (refusal.get() instanceof RuntimeException e) {
      throw e;
    }
    told = out.toString();
  }

  /** What the command printed. */
  String told() {
    return told;
  }

  /** Places of all files below the folder that it was run in, with slashes. */
  List<String> files() {
    try (Stream<Path> all = Files.walk(here)) {
      return all.filter(each -> !each.equals(here))
          .map(each -> here.relativize(each).toString())
          .sorted()
          .toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Compiles a project with all warnings as errors and runs its tests in its folder. */
  void build(String project) throws IOException, InterruptedException {
    Path folder = here.resolve(project).toAbsolutePath();
    Path classes = Files.createDirectories(folder.resolve("classes"));
    Path tests = Files.createDirectories(folder.resolve("test-classes"));
    String platform = System.getProperty("java.class.path");
    compile(folder.resolve("src/main/java"), classes, platform);
    copy(folder.resolve("src/main/resources"), classes);
    String path = classes + File.pathSeparator + platform;
    compile(folder.resolve("src/test/java"), tests, path);
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    Path output = folder.resolve("tests.txt");
    Process process =
        new ProcessBuilder(
                java,
                "-XX:TieredStopAtLevel=1",
                "-XX:+UseSerialGC",
                "-cp",
                tests + File.pathSeparator + path,
                RunTests.class.getName(),
                tests.toString())
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    assertThat(process.waitFor()).as(Files.readString(output)).isZero();
    assertThat(Files.readString(output)).containsPattern("succeeded: [1-9]");
  }

  private static void compile(Path sources, Path into, String classPath) throws IOException {
    List<Path> files = new ArrayList<>();
    if (Files.isDirectory(sources)) {
      try (Stream<Path> all = Files.walk(sources)) {
        all.filter(each -> each.toString().endsWith(".java")).forEach(files::add);
      }
    }
    if (files.isEmpty()) {
      return; // a vehicle from a file has no code but its test
    }
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    StringWriter errors = new StringWriter();
    List<String> options =
        List.of(
            "-Xlint:all,-path,-classfile", // what other people's jars contain and name
            "-Xdoclint:all/protected,-missing",
            "-Werror",
            "-proc:none",
            "--release",
            "17",
            "-cp",
            classPath,
            "-d",
            into.toString());
    try (StandardJavaFileManager manager = compiler.getStandardFileManager(null, null, null)) {
      boolean compiled =
          compiler
              .getTask(
                  errors, manager, null, options, null, manager.getJavaFileObjectsFromPaths(files))
              .call();
      assertThat(compiled).as(errors.toString()).isTrue();
    }
  }

  private static void copy(Path from, Path to) throws IOException {
    if (!Files.isDirectory(from)) {
      return;
    }
    try (Stream<Path> all = Files.walk(from).sorted(Comparator.naturalOrder())) {
      for (Path each : all.filter(Files::isRegularFile).toList()) {
        Path target = to.resolve(from.relativize(each).toString());
        Files.createDirectories(target.getParent());
        Files.copy(each, target);
      }
    }
  }
}
