package org.u2sa.scenarios.ugv;

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
 * What {@code u2sa demo ugv} answered, run in this process as the script {@code u2sa} would.
 *
 * @param exitCode what the shell would see
 * @param out standard output
 * @param err standard error
 * @param directory where its files are
 */
record UgvCommandLine(int exitCode, String out, String err, Path directory) {

  /** Without a broker for others. */
  static UgvCommandLine demo(Path directory, String... options) {
    return demo(directory, 0, options);
  }

  /** With a broker at that port; 0: none. */
  static UgvCommandLine demo(Path directory, int port, String... options) {
    System.setProperty("u2sa.home", repository().toString());
    List<String> arguments =
        new ArrayList<>(
            List.of("demo", "ugv", "--port", String.valueOf(port), "--out", directory.toString()));
    arguments.addAll(List.of(options));
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int exitCode =
        Main.run(
            new PrintWriter(out, true),
            new PrintWriter(err, true),
            arguments.toArray(new String[0]));
    return new UgvCommandLine(exitCode, out.toString(), err.toString(), directory);
  }

  /** The folder that holds {@code config} and {@code missions}: a test runs in its module's. */
  static Path repository() {
    Path folder = Path.of("").toAbsolutePath();
    while (!Files.isDirectory(folder.resolve("config/ugv"))) {
      folder = folder.getParent();
      if (folder == null) {
        throw new IllegalStateException("there is no config/ugv above the working directory");
      }
    }
    return folder;
  }

  /** Its {@code summary.json}. */
  JsonNode summary() {
    try {
      return new ObjectMapper().readTree(directory.resolve("summary.json").toFile());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  byte[] track() {
    try {
      return Files.readAllBytes(directory.resolve("track.csv"));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
