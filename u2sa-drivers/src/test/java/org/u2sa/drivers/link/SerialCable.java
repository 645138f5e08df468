package org.u2sa.drivers.link;

import static org.awaitility.Awaitility.await;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import org.u2sa.testkit.ForeignPrograms;

/** A serial port that socat makes: a pseudo terminal, with the device at its other end. */
public final class SerialCable {
  private final String program;
  private final Path path;
  private final MemoryLink device = new MemoryLink();
  private final DeviceServer server = new DeviceServer(device);
  private Process socat;

  private SerialCable(String program, Path path) throws IOException {
    this.program = program;
    this.path = path;
    plug();
  }

  /** Skips the test where there is no socat, except under CI, where it fails. */
  public static SerialCable required(Path path) throws IOException {
    return new SerialCable(ForeignPrograms.ofThisMachine().required("socat"), path);
  }

  /** The port, as the link's address has it. */
  public Path path() {
    return path;
  }

  /** What is at the far end. */
  MemoryLink device() {
    return device;
  }

  void plug() throws IOException {
    socat =
        new ProcessBuilder(program, "pty,raw,echo=0,link=" + path, server.address())
            .redirectErrorStream(true)
            .redirectOutput(new File(path + ".log"))
            .start();
    await().atMost(Duration.ofSeconds(30)).until(() -> Files.exists(path));
  }

  void unplug() throws InterruptedException {
    socat.destroy();
    if (!socat.waitFor(30, TimeUnit.SECONDS)) {
      socat.destroyForcibly().waitFor();
    }
    await().atMost(Duration.ofSeconds(30)).until(() -> !Files.exists(path));
  }

  /** Takes it away for good. */
  public void remove() throws IOException, InterruptedException {
    socat.destroy();
    socat.waitFor(30, TimeUnit.SECONDS);
    server.close();
  }
}
