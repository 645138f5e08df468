package org.u2sa.drivers.link;

import static org.awaitility.Awaitility.await;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import org.u2sa.testkit.ForeignPrograms;

/** A serial port that socat makes: a pseudo terminal, joined to a device behind TCP. */
public final class SerialCable {
  private final String program;
  private final Path path;
  private final String address;
  private Process socat;

  private SerialCable(String program, Path path, String address) throws IOException {
    this.program = program;
    this.path = path;
    this.address = address;
    plug();
  }

  /**
   * Skips the test where there is no socat, except under CI, where it fails.
   *
   * @param address of the device: tcp:HOST:PORT
   */
  public static SerialCable required(Path path, String address) throws IOException {
    return new SerialCable(ForeignPrograms.ofThisMachine().required("socat"), path, address);
  }

  /** The port, as the link's address has it. */
  public Path path() {
    return path;
  }

  public void plug() throws IOException {
    socat =
        new ProcessBuilder(program, "pty,raw,echo=0,link=" + path, address)
            .redirectErrorStream(true)
            .redirectOutput(new File(path + ".log"))
            .start();
    await().atMost(Duration.ofSeconds(30)).until(() -> Files.exists(path));
  }

  public void unplug() throws InterruptedException {
    socat.destroy();
    if (!socat.waitFor(30, TimeUnit.SECONDS)) {
      socat.destroyForcibly().waitFor();
    }
    await().atMost(Duration.ofSeconds(30)).until(() -> !Files.exists(path));
  }
}
