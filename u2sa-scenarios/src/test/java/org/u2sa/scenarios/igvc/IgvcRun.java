package org.u2sa.scenarios.igvc;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.cli.Main;

/**
 * What {@code u2sa demo igvc} did, run in this process as the script {@code u2sa} would.
 *
 * @param exitCode what the shell would see
 * @param said standard output and error
 * @param directory where its files are
 */
record IgvcRun(int exitCode, String said, Path directory) {
  static IgvcRun of(Path directory, Course course, long seed, String... options) {
    System.setProperty("u2sa.home", repository().toString());
    Path file = directory.resolveSibling(directory.getFileName() + ".xml");
    CourseFile.write(course, file);
    List<String> arguments = new ArrayList<>(List.of("demo", "igvc", "--port", "0"));
    arguments.addAll(List.of("--out", directory.toString(), "--course", file.toString()));
    arguments.addAll(List.of("--seed", String.valueOf(seed)));
    arguments.addAll(List.of(options));
    StringWriter said = new StringWriter();
    PrintWriter writer = new PrintWriter(said, true);
    int exitCode = Main.run(writer, writer, arguments.toArray(new String[0]));
    return new IgvcRun(exitCode, said.toString(), directory);
  }

  /** The folder that holds {@code config}: a test runs in its module's. */
  private static Path repository() {
    Path folder = Path.of("").toAbsolutePath();
    while (!Files.isDirectory(folder.resolve("config/igvc"))) {
      folder = folder.getParent();
      if (folder == null) {
        throw new IllegalStateException("there is no config/igvc above the working directory");
      }
    }
    return folder;
  }

  JsonNode summary() {
    try {
      return new ObjectMapper().readTree(directory.resolve("summary.json").toFile());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  int figure(String name) {
    return summary().path(name).asInt(-1);
  }

  byte[] file(String name) {
    try {
      return Files.readAllBytes(directory.resolve(name));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
