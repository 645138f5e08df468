package org.u2sa.drivers.ioio;

import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.drivers.link.SerialCable;
import org.u2sa.testkit.NeedsProgram;

/** A board at a serial port: a pseudo terminal that socat joins to the simulated one. */
@NeedsProgram("socat")
class SerialBoardTest {
  private final TcpBench on = new TcpBench();
  @TempDir private Path directory;

  @AfterEach
  void close() {
    on.close();
  }

  @Test
  void connect_serialPort_drivesThePinsAndComesBackAfterUnplugging() throws Exception {
    SerialCable cable =
        SerialCable.required(directory.resolve("board"), "tcp:127.0.0.1:" + on.server.port());
    try (BoardConnector connector =
        TcpBench.connector(BoardConnection.of("serial:" + cable.path()))) {
      on.awaitBoard(connector).pins().pulse(0, 1.7e-3);
      on.awaitWidth(1.7e-3);

      cable.unplug();
      on.awaitLoss(connector);
      on.awaitWidth(0.0);

      cable.plug();
      on.awaitBoardAgain(connector).pins().pulse(0, 1.7e-3);
      on.awaitWidth(1.7e-3);
    } finally {
      cable.unplug();
    }
  }
}
