package org.u2sa.cli.doctor;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Finds programs as the shell would, and runs them. */
final class Programs {
  private static final int WAIT_S = 5;
  private static final int FIRST_BYTES = 4096;

  private final List<Path> folders;

  Programs(Map<String, String> environment) {
    folders =
        Stream.of(environment.getOrDefault("PATH", "").split(File.pathSeparator))
            .filter(folder -> !folder.isEmpty())
            .map(Path::of)
            .collect(Collectors.toList());
  }

  Optional<Path> find(String name) {
    return folders.stream()
        .map(folder -> folder.resolve(name))
        .filter(file -> Files.isRegularFile(file) && Files.isExecutable(file))
        .findFirst();
  }

  /**
   * First line of a program's output, on stdout or stderr; empty if none arrives within five
   * seconds or the program cannot be started.
   */
  Optional<String> firstLine(Path program, String... arguments) throws InterruptedException {
    List<String> command =
        Stream.concat(Stream.of(program.toString()), Stream.of(arguments))
            .collect(Collectors.toList());
    Process process;
    try {
      process = new ProcessBuilder(command).redirectErrorStream(true).start();
      process.getOutputStream().close();
      if (!process.waitFor(WAIT_S, TimeUnit.SECONDS)) {
        process.destroyForcibly();
        return Optional.empty();
      }
      String text =
          new String(process.getInputStream().readNBytes(FIRST_BYTES), StandardCharsets.UTF_8);
      return text.lines().filter(line -> !line.isBlank()).findFirst();
    } catch (IOException e) {
      return Optional.of("cannot be started: " + e.getMessage());
    }
  }
}
