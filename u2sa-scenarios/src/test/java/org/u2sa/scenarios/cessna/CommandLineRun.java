package org.u2sa.scenarios.cessna;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.cli.Main;

/**
 * What {@code u2sa} answered to one command, run in this process as the script {@code u2sa} would.
 *
 * @param exitCode what the shell would see
 * @param out standard output
 * @param err standard error
 */
record CommandLineRun(int exitCode, String out, String err) {

  static CommandLineRun of(String... arguments) {
    System.setProperty("u2sa.home", repository().toString());
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int exitCode = Main.run(new PrintWriter(out, true), new PrintWriter(err, true), arguments);
    return new CommandLineRun(exitCode, out.toString(), err.toString());
  }

  /** The demo's answer, without a broker for others. */
  static CommandLineRun demo(Path out, String... options) {
    List<String> arguments =
        new ArrayList<>(List.of("demo", "cessna", "--port", "0", "--out", out.toString()));
    arguments.addAll(List.of(options));
    return of(arguments.toArray(new String[0]));
  }

  /** The folder that holds {@code config} and {@code missions}: a test runs in its module's. */
  static Path repository() {
    Path folder = Paths.get("").toAbsolutePath();
    while (!Files.isDirectory(folder.resolve("config/cessna"))) {
      folder = folder.getParent();
      if (folder == null) {
        throw new IllegalStateException("there is no config/cessna above the working directory");
      }
    }
    return folder;
  }
}
