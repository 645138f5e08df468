package org.u2sa.scenarios.run;

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
import org.u2sa.testkit.Repository;

/**
 * What {@code u2sa} answered to one command, run in this process as the script {@code u2sa} would.
 *
 * @param exitCode what the shell would see
 * @param out standard output
 * @param err standard error
 * @param directory where the files of a demo's run are
 */
public record CommandLineRun(int exitCode, String out, String err, Path directory) {
  /** Runs a command that writes no files, or whose files do not matter. */
  public static CommandLineRun of(String... arguments) {
    return of(Path.of(""), List.of(arguments));
  }

  /** Runs a demo without a broker for others. */
  public static CommandLineRun demo(String name, Path directory, String... options) {
    return demo(name, directory, 0, options);
  }

  /** Runs a demo with a broker at that port; 0: none. */
  public static CommandLineRun demo(String name, Path directory, int port, String... options) {
    List<String> arguments = new ArrayList<>(List.of("demo", name, "--port", "" + port));
    arguments.addAll(List.of("--out", directory.toString()));
    arguments.addAll(List.of(options));
    return of(directory, arguments);
  }

  private static CommandLineRun of(Path directory, List<String> arguments) {
    System.setProperty("u2sa.home", Repository.root().toString());
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int exitCode =
        Main.run(
            new PrintWriter(out, true),
            new PrintWriter(err, true),
            arguments.toArray(new String[0]));
    return new CommandLineRun(exitCode, out.toString(), err.toString(), directory);
  }

  /** Its {@code summary.json}. */
  public JsonNode summary() {
    try {
      return new ObjectMapper().readTree(file("summary.json"));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** An integer of its summary; -1 if absent. */
  public int figure(String name) {
    return summary().path(name).asInt(-1);
  }

  /** Its {@code track.csv}. */
  public byte[] track() {
    return file("track.csv");
  }

  /** The content of one of its files. */
  public byte[] file(String name) {
    try {
      return Files.readAllBytes(directory.resolve(name));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Standard output and error. */
  public String said() {
    return out + err;
  }
}
