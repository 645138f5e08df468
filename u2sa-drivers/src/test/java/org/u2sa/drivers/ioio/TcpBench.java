package org.u2sa.drivers.ioio;

import static org.awaitility.Awaitility.await;

import java.time.Duration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.sim.ioio.IoioTcpServer;

/** A bench whose board is served over TCP in real time. */
final class TcpBench implements AutoCloseable {
  static final Duration PATIENCE = Duration.ofSeconds(30);
  static final double RESOLUTION_S = 0.125e-6;
  static final double SILENT_AFTER_S = 20.0; // not in these tests, however slow they run

  final Clock clock = new SystemClock();
  final Bench bench = new Bench();
  final IoioTcpServer server = new IoioTcpServer(bench.firmware, clock, 0);

  /** The way to the board. */
  BoardConnection connection() {
    return BoardConnection.of("tcp:127.0.0.1:" + server.port());
  }

  /** A connector of a connection to the board. */
  BoardConnector connector() {
    return connector(connection());
  }

  /** A connector of a connection. */
  static BoardConnector connector(BoardConnection connection) {
    return new BoardConnector(connection, BoardConnectorTest.PLAN, SILENT_AFTER_S);
  }

  /** Starts the connector, and waits until the board is there. */
  BoardSession awaitBoard(BoardConnector connector) {
    connector.start();
    return awaitBoardAgain(connector);
  }

  /** Waits until the board is there. */
  BoardSession awaitBoardAgain(BoardConnector connector) {
    await("the board")
        .atMost(PATIENCE)
        .until(
            () -> {
              connector.step(clock.micros());
              return connector.session().isPresent();
            });
    return connector.session().orElseThrow();
  }

  /** Waits until the board is not there. */
  void awaitLoss(BoardConnector connector) {
    await("the loss")
        .atMost(PATIENCE)
        .until(
            () -> {
              connector.step(clock.micros());
              return connector.session().isEmpty();
            });
  }

  /** Waits until the first motor's pulses are that wide. */
  void awaitWidth(double widthS) {
    await("pulses").atMost(PATIENCE).until(() -> Math.abs(bench.width(10) - widthS) < RESOLUTION_S);
  }

  @Override
  public void close() {
    server.close();
    LibraryThreads.awaitNone();
  }
}
