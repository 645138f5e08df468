package org.u2sa.spark;

import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.Callable;
import org.u2sa.interfaces.JsonText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** A run that takes no time: says its seed and its process, writes a file, fails as it is told. */
@Command(name = "trial", description = "A run for tests.")
final class TrialCommand implements Callable<Integer> {
  static final String FILE = "trial.txt";
  static final String GO_ON = "go-on";

  @Spec private CommandSpec command;

  @Option(names = "--seed")
  private long seed;

  @Option(names = "--out")
  private Path out;

  @Option(names = "--exit")
  private int exit;

  @Option(names = "--halt")
  private boolean halt;

  @Option(
      names = "--meet",
      description = "Says in this folder that the run has begun, and waits for the word to go on.")
  private Path meeting;

  @Override
  public Integer call() throws IOException {
    if (halt) {
      Runtime.getRuntime().halt(137); // as kill -9 would
    }
    Files.createDirectories(out);
    Files.writeString(out.resolve(FILE), "seed " + seed);
    long pid = ProcessHandle.current().pid();
    if (meeting != null) {
      Files.writeString(meeting.resolve(Long.toString(pid)), "");
      await().atMost(Duration.ofMinutes(5)).until(() -> Files.exists(meeting.resolve(GO_ON)));
    }
    command.commandLine().getOut().println(new JsonText().put("seed", seed).put("pid", pid).line());
    return exit;
  }

  static long seed(String output) {
    return number(output, "seed");
  }

  static long pid(String output) {
    return number(output, "pid");
  }

  private static long number(String output, String name) {
    return Long.parseLong(output.strip().replaceFirst(".*\"" + name + "\":(\\d+).*", "$1"));
  }
}
