package org.u2sa.drivers.mavlink;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.testkit.ForeignPrograms;
import org.u2sa.testkit.ProcessTree;

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
    String python = ForeignPrograms.ofThisMachine().required("python3", "pymavlink.mavutil");
    Process process =
        new ProcessBuilder(python, SCRIPT.toString(), kind)
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    BufferedReader out = new BufferedReader(new InputStreamReader(process.getInputStream(), UTF_8));
    String first = out.readLine();
    assertThat(first).startsWith("port ");
    return new PymavlinkVehicle(process, out, Integer.parseInt(first.substring(5)));
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
    ProcessTree.end(process);
  }
}
