package org.u2sa.drivers.mavlink;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** A vehicle that pymavlink plays in a process of its own: src/test/python/vehicle.py. */
final class PymavlinkVehicle implements AutoCloseable {
  private static final Path SCRIPT = Paths.get("src/test/python/vehicle.py").toAbsolutePath();

  private final Process process;
  private final int port;
  private final List<String> heard = new ArrayList<>(); // lines of JSON; guarded by itself

  private PymavlinkVehicle(Process process, BufferedReader out, int port) {
    this.process = process;
    this.port = port;
    Thread thread = new Thread(() -> listen(out), "hears pymavlink");
    thread.setDaemon(true);
    thread.start();
  }

  /**
   * Starts one. Skips the test where no Python with pymavlink is, except under CI, where it fails.
   *
   * @param kind "tcp" or "udp"
   */
  static PymavlinkVehicle start(String kind) throws IOException {
    Optional<String> able = Program.ABLE;
    if ("true".equals(System.getenv("CI"))) {
      assertThat(able).as("CI needs python3 with pymavlink").isPresent();
    }
    assumeTrue(able.isPresent(), "python3 with pymavlink is not here");
    Process process =
        new ProcessBuilder(able.orElseThrow(), SCRIPT.toString(), kind)
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    BufferedReader out = new BufferedReader(new InputStreamReader(process.getInputStream(), UTF_8));
    String first = out.readLine();
    assertThat(first).startsWith("port ");
    return new PymavlinkVehicle(process, out, Integer.parseInt(first.substring(5)));
  }

  /** Looked for once: importing pymavlink takes a second. */
  private static final class Program {
    private static final Optional<String> ABLE =
        Stream.of("python3", "/usr/bin/python3").filter(Program::hasPymavlink).findFirst();

    private static boolean hasPymavlink(String program) {
      try {
        Process process =
            new ProcessBuilder(program, "-c", "import pymavlink.mavutil")
                .redirectErrorStream(true)
                .start();
        process.getInputStream().readAllBytes();
        return process.waitFor() == 0;
      } catch (IOException e) {
        return false; // no such program
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return false;
      }
    }
  }

  private void listen(BufferedReader out) {
    try {
      for (String line = out.readLine(); line != null; line = out.readLine()) {
        synchronized (heard) {
          heard.add(line);
        }
      }
    } catch (IOException e) {
      synchronized (heard) {
        heard.add("ended: " + e.getMessage());
      }
    }
  }

  /** Where it listens. */
  int port() {
    return port;
  }

  /** All messages of a type so far, as JSON, oldest first. */
  List<String> heard(String type) {
    synchronized (heard) {
      return heard.stream()
          .filter(line -> line.contains("\"mavpackettype\": \"" + type + "\""))
          .toList();
    }
  }

  /** Tells it "quiet" or "speak". */
  void tell(String word) {
    try {
      process.getOutputStream().write((word + "\n").getBytes(UTF_8));
      process.getOutputStream().flush();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() throws IOException {
    process.getOutputStream().close(); // the end of its input ends it
    try {
      if (!process.waitFor(10, TimeUnit.SECONDS)) {
        process.destroyForcibly();
      }
    } catch (InterruptedException e) {
      process.destroyForcibly();
      Thread.currentThread().interrupt();
    }
  }
}
