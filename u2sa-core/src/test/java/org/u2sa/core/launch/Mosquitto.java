package org.u2sa.core.launch;

import static org.awaitility.Awaitility.await;

import java.io.File;
import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.testkit.ForeignPrograms;

/** Mosquitto on a port of this machine, until it is closed. */
public final class Mosquitto implements AutoCloseable {
  private final Process process;
  private final int port;

  private Mosquitto(Process process, int port) {
    this.process = process;
    this.port = port;
  }

  /** Starts it. Skips the test where it is not installed, except under CI, where it fails. */
  static Mosquitto start(int port) throws IOException {
    return start(port, "-p", String.valueOf(port));
  }

  /** Likewise, with these arguments, which make it listen on this port. */
  public static Mosquitto start(int port, String... arguments) throws IOException {
    List<String> command = new ArrayList<>();
    command.add(ForeignPrograms.ofThisMachine().required("mosquitto"));
    command.addAll(List.of(arguments));
    Process process =
        new ProcessBuilder(command)
            .redirectErrorStream(true)
            .redirectOutput(new File("/dev/null"))
            .start();
    await()
        .atMost(Duration.ofSeconds(30))
        .ignoreExceptions()
        .until(
            () -> {
              new Socket("127.0.0.1", port).close();
              return true;
            });
    return new Mosquitto(process, port);
  }

  int port() {
    return port;
  }

  @Override
  public void close() {
    process.destroyForcibly().onExit().join();
  }
}
