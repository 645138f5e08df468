package org.u2sa.scenarios.client;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.u2sa.scenarios.run.ForeignProgram;
import org.u2sa.testkit.FreePort;
import org.u2sa.testkit.ProcessTree;
import org.u2sa.testkit.Repository;

/** A demo in a process of its own, and clients of it in Python. */
final class RunningDemo implements AutoCloseable {
  private static final Duration LONG = Duration.ofMinutes(2);
  private static final Path SCRIPTS =
      Repository.root().resolve("u2sa-scenarios/src/test/python/stations");

  private final Path folder;
  private final Path output;
  private final int port = FreePort.find();
  private final Process process;

  /**
   * Starts it and waits until it has said something.
   *
   * @param folder receives its output, and its run in the folder {@code out}
   */
  RunningDemo(Path folder, String waitFor, String... arguments) throws IOException {
    this.folder = folder;
    output = folder.resolve("demo.txt");
    List<String> command = new ArrayList<>(List.of("demo"));
    command.addAll(List.of(arguments));
    command.addAll(List.of("--realtime", "--port=" + port, "--out=" + out()));
    process = ForeignProgram.u2sa(output, command.toArray(new String[0]));
    await().atMost(LONG).until(() -> said().contains(waitFor) || !process.isAlive());
    assertThat(said()).contains(waitFor);
  }

  /** Folder of the run. */
  Path out() {
    return folder.resolve("out");
  }

  /** Port of its broker. */
  int port() {
    return port;
  }

  String said() throws IOException {
    return Files.exists(output) ? Files.readString(output, UTF_8) : "";
  }

  /** Runs a client to its end and returns what it printed; it must succeed. */
  String client(String python, String script, String... arguments)
      throws IOException, InterruptedException {
    Process client = start(python, script, arguments);
    Path printed = folder.resolve(script + ".txt");
    try {
      assertThat(client.waitFor(40, TimeUnit.MINUTES)).as(script + " ends").isTrue();
    } finally {
      ProcessTree.kill(client);
    }
    String text = Files.readString(printed, UTF_8);
    assertThat(client.exitValue()).as(text).isZero();
    return text;
  }

  /** Starts a script beside it; the caller ends it. */
  Process start(String python, String script, String... arguments) throws IOException {
    List<String> command =
        new ArrayList<>(List.of(python, "-u", SCRIPTS.resolve(script).toString()));
    command.addAll(List.of(arguments));
    return new ProcessBuilder(command)
        .directory(folder.toFile())
        .redirectErrorStream(true)
        .redirectOutput(folder.resolve(script + ".txt").toFile())
        .start();
  }

  @Override
  public void close() {
    ProcessTree.kill(process);
  }
}
