package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import ioio.lib.api.exception.ConnectionLostException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.time.Clock;

/** Boards over TCP that hang, stay silent, garble, or are none: given up, and connected again. */
class BadBoardTest {
  private final TcpBench on = new TcpBench();

  @AfterEach
  void close() {
    on.close();
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 7, 28, 30, 31, 32, 33, 34, 35, 37, 41, 50, 75, 150})
  void session_oneByteOfTheBoardIsChanged_servesOrIsConnectedAnew(int index) throws Exception {
    try (BoardConnector connector =
        TcpBench.connector(CutConnection.garbled(on.connection(), index))) {
      connector.start();
      await("a board that serves")
          .atMost(TcpBench.PATIENCE)
          .dontCatchUncaughtExceptions() // the library's own thread may end by one
          .ignoreException(ConnectionLostException.class)
          .until(
              () -> {
                connector.step(on.clock.micros());
                if (connector.session().isEmpty()) {
                  return false;
                }
                connector.session().get().pins().pulse(0, 1.6e-3);
                return Math.abs(on.bench.width(10) - 1.6e-3) < TcpBench.RESOLUTION_S;
              });
    }
  }

  @Test
  void step_somethingThatDoesNotAnswer_isGivenUpWithTheReason() throws IOException {
    try (ServerSocket mute = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
        BoardConnector connector =
            TcpBench.connector(BoardConnection.of("tcp:127.0.0.1:" + mute.getLocalPort()))) {
      connector.start();
      long[] time = {0};
      await()
          .atMost(TcpBench.PATIENCE)
          .until(
              () -> {
                time[0] += 1_000_000; // of the run: 3 s pass in three calls
                connector.step(time[0]);
                return connector.trouble().equals("no answer within 3.0 s");
              });
    }
  }

  @Test
  void step_boardThatFallsSilent_isGivenUpAndConnectedAnew() {
    try (BoardConnector connector = on.connector()) {
      BoardSession before = on.awaitBoard(connector);
      long now = on.clock.micros();
      on.server.hold(true);
      connector.step(now);
      await()
          .atMost(TcpBench.PATIENCE)
          .until(
              () -> {
                long bytes = before.link().received();
                connector.step(now);
                return bytes == before.link().received();
              });
      connector.step(now + Clock.micros(TcpBench.SILENT_AFTER_S) + 1);
      assertThat(connector.session()).isEmpty();
      on.server.hold(false);
      await()
          .atMost(TcpBench.PATIENCE)
          .until(() -> connector.session().filter(after -> after != before).isPresent());
    }
  }

  @Test
  void step_boardThatSendsButTakesNothing_isGivenUpAndItsPulsesEnd() throws Exception {
    DeafConnection way = new DeafConnection(on.connection());
    try (BoardConnector connector = new BoardConnector(way, BoardConnectorTest.PLAN, 1.0)) {
      connector.start();
      await("pulses")
          .atMost(TcpBench.PATIENCE)
          .ignoreException(ConnectionLostException.class)
          .until(
              () -> {
                connector.step(on.clock.micros());
                if (connector.session().isPresent()) {
                  connector.session().get().pins().pulse(0, 1.8e-3);
                }
                return on.bench.width(10) > 0.0;
              });
      way.deaf(true);
      await("the loss")
          .atMost(TcpBench.PATIENCE)
          .until(
              () -> {
                connector.step(on.clock.micros());
                return connector.session().isEmpty() && on.bench.width(10) == 0.0;
              });
      way.deaf(false);
      on.awaitBoardAgain(connector);
    }
  }

  @Test
  void isTaken_boardThatTakesNothing_neverUntilItIsBack() throws Exception {
    DeafConnection way = new DeafConnection(on.connection());
    StopEcho echo = new StopEcho();
    try (BoardConnector connector = new BoardConnector(way, BoardConnectorTest.PLAN, 1.0)) {
      connector.start();
      on.awaitBoardAgain(connector);
      echo.stop(connector.session());
      await("the confirmation")
          .atMost(TcpBench.PATIENCE)
          .until(() -> echo.isTaken(connector.session()));

      way.deaf(true);
      echo.stop(connector.session());
      await("the loss")
          .atMost(TcpBench.PATIENCE)
          .until(
              () -> {
                connector.step(on.clock.micros());
                assertThat(echo.isTaken(connector.session())).isFalse();
                return connector.session().isEmpty();
              });
      assertThat(echo.isTaken(connector.session())).isFalse();

      way.deaf(false);
      on.awaitBoardAgain(connector);
      await("the confirmation after its return")
          .atMost(TcpBench.PATIENCE)
          .until(() -> echo.isTaken(connector.session()));
    }
  }

  @Test
  void isTaken_boardLostBeforeTheStop_neverUntilItIsBack() throws Exception {
    DeafConnection way = new DeafConnection(on.connection());
    StopEcho echo = new StopEcho();
    try (BoardConnector connector = new BoardConnector(way, BoardConnectorTest.PLAN, 1.0)) {
      connector.start();
      on.awaitBoardAgain(connector);
      way.deaf(true);
      await("the loss")
          .atMost(TcpBench.PATIENCE)
          .until(
              () -> {
                connector.step(on.clock.micros());
                return connector.session().isEmpty();
              });

      echo.stop(connector.session());
      assertThat(echo.isTaken(connector.session())).isFalse();

      way.deaf(false);
      on.awaitBoardAgain(connector);
      await("the confirmation after its return")
          .atMost(TcpBench.PATIENCE)
          .until(() -> echo.isTaken(connector.session()));
    }
  }

  @Test
  void answers_boardThatServes_becomeMore() {
    try (BoardConnector connector = on.connector()) {
      BoardSession session = on.awaitBoard(connector);
      await().atMost(TcpBench.PATIENCE).until(() -> session.answers().orElseThrow() > 3);
    }
  }

  @Test
  void step_garbageInsteadOfABoard_isRefusedAndNoThreadIsLeft() throws IOException {
    try (ServerSocket other = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
      Thread talker = new Thread(() -> talk(other), "garbage");
      talker.start();
      try (BoardConnector connector =
          TcpBench.connector(BoardConnection.of("tcp:127.0.0.1:" + other.getLocalPort()))) {
        connector.start();
        await()
            .atMost(TcpBench.PATIENCE)
            .until(
                () -> {
                  connector.step(on.clock.micros());
                  return connector.trouble().contains("does not answer");
                });
        assertThat(connector.session()).isEmpty();
      }
    }
  }

  @Test
  void pulse_boardThatTakesNothing_neverWaits() {
    try (BoardConnector connector = on.connector()) {
      BoardSession session = on.awaitBoard(connector);
      on.server.hold(true);
      assertThatThrownBy(
              () -> {
                for (int i = 0; i < 10_000_000; i++) {
                  session.pins().pulse(0, i % 2 == 0 ? 1.4e-3 : 1.6e-3);
                }
              })
          .as("what piles up ends the connection")
          .isInstanceOf(ConnectionLostException.class);
      on.server.hold(false);
    }
  }

  private static void talk(ServerSocket other) {
    byte[] garbage = new byte[256];
    for (int i = 0; i < garbage.length; i++) {
      garbage[i] = (byte) (i * 37 + 36);
    }
    while (!other.isClosed()) {
      try (Socket host = other.accept()) {
        host.getOutputStream().write(garbage);
        host.getInputStream().read();
      } catch (IOException e) {
        continue; // the host has gone, or the test is over
      }
    }
  }
}
