package org.u2sa.testkit;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Mosquitto, the broker, as a process of its own, which can be killed and started again. */
public final class Mosquitto implements AutoCloseable {
  private final List<String> command = new ArrayList<>();
  private final int port;
  private Process process;

  private Mosquitto(int port, List<String> arguments) throws IOException {
    this.port = port;
    command.add(ForeignPrograms.ofThisMachine().required("mosquitto"));
    command.addAll(arguments);
    start();
  }

  /**
   * Starts it on this machine without a login. Skips the test where it is not installed, except
   * under CI, where the test fails.
   */
  public static Mosquitto start(int port) throws IOException {
    return start(port, "-p", String.valueOf(port));
  }

  /** Likewise, with these arguments, which make it listen on this port. */
  public static Mosquitto start(int port, String... arguments) throws IOException {
    return new Mosquitto(port, List.of(arguments));
  }

  /** Likewise, on a free port, with a long queue for clients that fall behind. */
  public static Mosquitto withLongQueues(Path folder) throws IOException {
    int port = FreePort.find();
    Path file = folder.resolve("mosquitto.conf");
    Files.writeString(
        file,
        "listener " + port + " 127.0.0.1\nallow_anonymous true\nmax_queued_messages 100000\n");
    return start(port, "-c", file.toString());
  }

  /** Starts it again after a {@link #kill}; returns once it listens. */
  public void start() throws IOException {
    process = new ProcessBuilder(command).redirectErrorStream(true).start();
    BufferedReader output = process.inputReader(UTF_8);
    StringBuilder said = new StringBuilder();
    String line = output.readLine();
    while (line != null && !line.endsWith(" running")) {
      said.append(line).append('\n');
      line = output.readLine();
    }
    if (line == null) {
      throw new IOException("mosquitto ended without listening:\n" + said);
    }
    Thread reader = new Thread(() -> discard(output), "mosquitto-output");
    reader.setDaemon(true);
    reader.start();
  }

  private static void discard(BufferedReader output) {
    try (output) {
      output.transferTo(Writer.nullWriter());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  public int port() {
    return port;
  }

  /** SIGKILL. */
  public void kill() {
    process.destroyForcibly().onExit().join();
  }

  @Override
  public void close() {
    kill();
  }
}
