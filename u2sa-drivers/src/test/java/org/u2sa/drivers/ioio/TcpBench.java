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

  /** A keeper of a connection to the board. */
  BoardKeeper keeper() {
    return keeper(connection());
  }

  /** A keeper of a connection. */
  static BoardKeeper keeper(BoardConnection connection) {
    return new BoardKeeper(connection, BoardKeeperTest.PLAN, SILENT_AFTER_S);
  }

  /** Starts the keeper, and waits until the board is there. */
  BoardSession awaitBoard(BoardKeeper keeper) {
    keeper.start();
    return awaitBoardAgain(keeper);
  }

  /** Waits until the board is there. */
  BoardSession awaitBoardAgain(BoardKeeper keeper) {
    await("the board")
        .atMost(PATIENCE)
        .until(
            () -> {
              keeper.step(clock.micros());
              return keeper.session().isPresent();
            });
    return keeper.session().orElseThrow();
  }

  /** Waits until the board is not there. */
  void awaitLoss(BoardKeeper keeper) {
    await("the loss")
        .atMost(PATIENCE)
        .until(
            () -> {
              keeper.step(clock.micros());
              return keeper.session().isEmpty();
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
