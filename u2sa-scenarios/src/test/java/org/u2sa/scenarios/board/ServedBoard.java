package org.u2sa.scenarios.board;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.scenarios.run.ForeignProgram;
import org.u2sa.testkit.ProcessTree;
import org.u2sa.testkit.Repository;

/** {@code u2sa board} in a virtual machine of its own, at any free port. */
final class ServedBoard implements AutoCloseable {
  private static final Duration PATIENCE = Duration.ofSeconds(90);
  private static final Pattern ADDRESS = Pattern.compile("IOIO board at (tcp|tls):[0-9.]+:(\\d+)");

  private final Path log;
  private final Process process;

  /**
   * @param vehicle file below the repository's root
   */
  ServedBoard(Path folder, String vehicle, String... options) throws IOException {
    log = folder.resolve("board.log");
    List<String> command =
        new ArrayList<>(
            List.of(
                "board",
                "--vehicle",
                Repository.root().resolve(vehicle).toString(),
                "--listen",
                "127.0.0.1:0"));
    command.addAll(List.of(options));
    process = ForeignProgram.u2sa(log, command.toArray(new String[0]));
    await("the board").atMost(PATIENCE).until(() -> ADDRESS.matcher(said()).find());
  }

  int port() {
    Matcher address = ADDRESS.matcher(said());
    assertThat(address.find()).as(said()).isTrue();
    return Integer.parseInt(address.group(2));
  }

  Socket connect() throws IOException {
    Socket socket = new Socket("127.0.0.1", port());
    socket.setSoTimeout((int) PATIENCE.toMillis());
    return socket;
  }

  /** All that it has printed. */
  String said() {
    try {
      return Files.readString(log);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  void awaitSaid(String words) {
    await(words).atMost(PATIENCE).until(() -> said().contains(words));
  }

  /** Number of lines with these words. */
  long lines(String words) {
    return said().lines().filter(line -> line.contains(words)).count();
  }

  /** Ends it as SIGTERM does; returns its exit code. */
  int end() throws InterruptedException {
    process.destroy();
    assertThat(process.waitFor(PATIENCE.toSeconds(), TimeUnit.SECONDS)).as("ends").isTrue();
    return process.exitValue();
  }

  @Override
  public void close() {
    ProcessTree.kill(process);
  }
}
