package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import java.util.List;
import java.util.Optional;

/** Mosquitto on a port of this machine, until it is closed. */
final class Mosquitto implements AutoCloseable {
  private final Process process;
  private final int port;

  private Mosquitto(Process process, int port) {
    this.process = process;
    this.port = port;
  }

  /** Starts it. Skips the test where it is not installed, except under CI, where it fails. */
  static Mosquitto start(int port) {
    Optional<Process> started = Optional.empty();
    for (String program : List.of("mosquitto", "/usr/sbin/mosquitto")) {
      if (started.isEmpty()) {
        started = start(program, port);
      }
    }
    if ("true".equals(System.getenv("CI"))) {
      assertThat(started).as("CI needs mosquitto").isPresent();
    }
    assumeTrue(started.isPresent(), "mosquitto is not here");
    Mosquitto mosquitto = new Mosquitto(started.orElseThrow(), port);
    await()
        .atMost(Duration.ofSeconds(30))
        .ignoreExceptions()
        .until(
            () -> {
              new Socket("127.0.0.1", port).close();
              return true;
            });
    return mosquitto;
  }

  private static Optional<Process> start(String program, int port) {
    try {
      return Optional.of(
          new ProcessBuilder(program, "-p", String.valueOf(port))
              .redirectErrorStream(true)
              .redirectOutput(new File("/dev/null"))
              .start());
    } catch (IOException e) {
      return Optional.empty(); // no such program
    }
  }

  int port() {
    return port;
  }

  @Override
  public void close() {
    process.destroyForcibly().onExit().join();
  }
}
