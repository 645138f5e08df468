package org.u2sa.drivers.ioio;

import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.sim.ioio.IoioTcpServer;
import org.u2sa.testkit.ForeignPrograms;
import org.u2sa.testkit.NeedsProgram;

/** A board at a serial port: a pseudo terminal that socat joins to the simulated one. */
@NeedsProgram("socat")
class SerialBoardTest {
  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final double SILENT_AFTER_S = 20.0;

  private final Clock clock = new SystemClock();
  private final Bench bench = new Bench();
  private final IoioTcpServer server = new IoioTcpServer(bench.firmware, clock, 0);
  @TempDir private Path directory;
  private Path port;
  private Process socat;

  @BeforeEach
  void plug() throws IOException {
    port = directory.resolve("board");
    plugIn();
  }

  private void plugIn() throws IOException {
    String program = ForeignPrograms.ofThisMachine().required("socat");
    socat =
        new ProcessBuilder(program, "pty,raw,echo=0,link=" + port, "tcp:127.0.0.1:" + server.port())
            .redirectErrorStream(true)
            .redirectOutput(directory.resolve("socat.log").toFile())
            .start();
    await().atMost(PATIENCE).until(() -> Files.exists(port));
  }

  private void unplug() throws InterruptedException {
    socat.destroy();
    if (!socat.waitFor(30, TimeUnit.SECONDS)) {
      socat.destroyForcibly().waitFor();
    }
  }

  @AfterEach
  void close() throws InterruptedException {
    if (socat != null) {
      unplug();
    }
    server.close();
    LibraryThreads.awaitNone();
  }

  private void awaitBoard(BoardConnector connector) {
    await("the board")
        .atMost(PATIENCE)
        .until(
            () -> {
              connector.step(clock.micros());
              return connector.session().isPresent();
            });
  }

  @Test
  void connect_serialPort_drivesThePinsAndComesBackAfterUnplugging() throws Exception {
    try (BoardConnector connector =
        new BoardConnector(
            BoardConnection.of("serial:" + port), BoardConnectorTest.PLAN, SILENT_AFTER_S)) {
      connector.start();
      awaitBoard(connector);
      connector.session().orElseThrow().pins().pulse(0, 1.7e-3);
      await().atMost(PATIENCE).until(() -> bench.width(10) > 1.6e-3);

      unplug();
      await()
          .atMost(PATIENCE)
          .until(
              () -> {
                connector.step(clock.micros());
                return connector.session().isEmpty() && bench.width(10) == 0.0;
              });
      plugIn();
      awaitBoard(connector);
      connector.session().orElseThrow().pins().pulse(0, 1.7e-3);
      await().atMost(PATIENCE).until(() -> bench.width(10) > 1.6e-3);
    }
  }
}
