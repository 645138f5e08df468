package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import ioio.lib.api.exception.ConnectionLostException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.Clock;
import org.u2sa.interfaces.SystemClock;
import org.u2sa.sim.ioio.IoioTcpServer;

/** The unmodified IOIO library against the firmware simulator over TCP, in real time. */
class TcpBoardTest {
  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final double RESOLUTION_S = 0.125e-6;
  private static final double SILENT_AFTER_S = 20.0; // not in these tests, however slow they run

  private final Clock clock = new SystemClock();
  private final Bench bench = new Bench();
  private final IoioTcpServer server = new IoioTcpServer(bench.firmware, clock, 0);

  @AfterEach
  void close() {
    server.close();
    LibraryThreads.awaitNone();
  }

  private BoardConnection connection() {
    return BoardConnection.of("tcp:127.0.0.1:" + server.port());
  }

  private BoardKeeper keeper() {
    return new BoardKeeper(connection(), BoardKeeperTest.PLAN, SILENT_AFTER_S);
  }

  private BoardSession awaitBoard(BoardKeeper keeper) {
    keeper.start();
    return awaitBoardAgain(keeper);
  }

  private BoardSession awaitBoardAgain(BoardKeeper keeper) {
    await("the board")
        .atMost(PATIENCE)
        .until(
            () -> {
              keeper.step(clock.micros());
              return keeper.session().isPresent();
            });
    return keeper.session().orElseThrow();
  }

  private void awaitLoss(BoardKeeper keeper) {
    await("the loss")
        .atMost(PATIENCE)
        .until(
            () -> {
              keeper.step(clock.micros());
              return keeper.session().isEmpty();
            });
  }

  private void awaitWidth(double widthS) {
    await("pulses").atMost(PATIENCE).until(() -> Math.abs(bench.width(10) - widthS) < RESOLUTION_S);
  }

  @Test
  void connect_everyPin_worksBothWays() throws Exception {
    bench.volts(40, 1.0);
    bench.pulses(35, 1.2e-3);
    byte[] text = "hello".getBytes(StandardCharsets.US_ASCII);
    try (BoardKeeper keeper = keeper()) {
      BoardPins pins = awaitBoard(keeper).pins();
      pins.pulse(0, 1.75e-3);
      awaitWidth(1.75e-3);
      await().atMost(PATIENCE).until(() -> pins.volts().isPresent());
      assertThat(pins.volts().getAsDouble()).isCloseTo(1.0, within(0.01));
      await().atMost(PATIENCE).until(() -> pins.nextRadioPulse().isPresent());
      UartLine line = pins.gps().orElseThrow();
      line.write(text);
      bench.send(6, text);
      byte[] buffer = new byte[64];
      await()
          .atMost(PATIENCE)
          .until(
              () -> {
                line.send(clock.micros(), Optional.empty());
                return Arrays.equals(bench.received(7), text);
              });
      int[] count = new int[1];
      await()
          .atMost(PATIENCE)
          .until(
              () -> {
                byte[] part = new byte[64];
                int more = line.read(part);
                System.arraycopy(part, 0, buffer, count[0], more);
                count[0] += more;
                return count[0] == text.length;
              });
      assertThat(Arrays.copyOf(buffer, count[0])).isEqualTo(text);
    }
    assertThat(bench.width(10)).as("after the close").isZero();
  }

  @Test
  void power_offAndOn_pinsFloatAndBoardIsBack() throws Exception {
    try (BoardKeeper keeper = keeper()) {
      BoardSession before = awaitBoard(keeper);
      before.pins().pulse(0, 1.9e-3);
      awaitWidth(1.9e-3);
      server.power(false);
      assertThat(bench.width(10)).isZero();
      awaitLoss(keeper);
      assertThatThrownBy(
              () -> {
                before.pins().pulse(0, 1.1e-3);
                before.pins().pulse(0, 1.2e-3);
              })
          .isInstanceOf(ConnectionLostException.class);
      server.power(true);
      awaitBoardAgain(keeper).pins().pulse(0, 1.5e-3);
      awaitWidth(1.5e-3);
    }
  }

  @Test
  void session_cutAtManyBytes_boardIsBackAndNoThreadIsLeft() {
    for (int bytes = 0; bytes < 110; bytes += 27) {
      try (BoardKeeper in =
          new BoardKeeper(
              new CutConnection(connection(), bytes, Integer.MAX_VALUE),
              BoardKeeperTest.PLAN,
              SILENT_AFTER_S)) {
        awaitBoard(in);
      }
      try (BoardKeeper out =
          new BoardKeeper(
              new CutConnection(connection(), Integer.MAX_VALUE, bytes),
              BoardKeeperTest.PLAN,
              SILENT_AFTER_S)) {
        awaitBoard(out);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 7, 28, 30, 31, 32, 33, 34, 35, 37, 41, 50, 75, 150})
  void session_oneByteOfTheBoardIsChanged_servesOrIsConnectedAnew(int index) throws Exception {
    try (BoardKeeper keeper =
        new BoardKeeper(
            CutConnection.garbled(connection(), index), BoardKeeperTest.PLAN, SILENT_AFTER_S)) {
      keeper.start();
      await("a board that serves")
          .atMost(PATIENCE)
          .dontCatchUncaughtExceptions() // the library's own thread may end by one
          .ignoreException(ConnectionLostException.class)
          .until(
              () -> {
                keeper.step(clock.micros());
                if (keeper.session().isEmpty()) {
                  return false;
                }
                keeper.session().get().pins().pulse(0, 1.6e-3);
                return Math.abs(bench.width(10) - 1.6e-3) < RESOLUTION_S;
              });
    }
  }

  @Test
  void step_somethingThatDoesNotAnswer_isGivenUpWithTheReason() throws IOException {
    try (ServerSocket mute = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
        BoardKeeper keeper =
            new BoardKeeper(
                BoardConnection.of("tcp:127.0.0.1:" + mute.getLocalPort()),
                BoardKeeperTest.PLAN,
                SILENT_AFTER_S)) {
      keeper.start();
      long[] time = {0};
      await()
          .atMost(PATIENCE)
          .until(
              () -> {
                time[0] += 1_000_000; // of the run: 3 s pass in three calls
                keeper.step(time[0]);
                return keeper.trouble().equals("no answer within 3.0 s");
              });
    }
  }

  @Test
  void step_boardThatFallsSilent_isGivenUpAndConnectedAnew() {
    try (BoardKeeper keeper = keeper()) {
      BoardSession before = awaitBoard(keeper);
      long now = clock.micros();
      server.hold(true);
      keeper.step(now);
      await()
          .atMost(PATIENCE)
          .until(
              () -> {
                long bytes = before.link().received();
                keeper.step(now);
                return bytes == before.link().received();
              });
      keeper.step(now + Clock.micros(SILENT_AFTER_S) + 1);
      assertThat(keeper.session()).isEmpty();
      server.hold(false);
      await()
          .atMost(PATIENCE)
          .until(() -> keeper.session().filter(after -> after != before).isPresent());
    }
  }

  @Test
  void step_garbageInsteadOfABoard_isRefusedAndNoThreadIsLeft() throws IOException {
    try (ServerSocket other = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
      Thread talker = new Thread(() -> talk(other), "garbage");
      talker.start();
      try (BoardKeeper keeper =
          new BoardKeeper(
              BoardConnection.of("tcp:127.0.0.1:" + other.getLocalPort()),
              BoardKeeperTest.PLAN,
              SILENT_AFTER_S)) {
        keeper.start();
        await()
            .atMost(PATIENCE)
            .until(
                () -> {
                  keeper.step(clock.micros());
                  return keeper.trouble().contains("does not answer");
                });
        assertThat(keeper.session()).isEmpty();
      }
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

  @Test
  void pulse_boardThatTakesNothing_neverWaits() {
    try (BoardKeeper keeper = keeper()) {
      BoardSession session = awaitBoard(keeper);
      server.hold(true);
      assertThatThrownBy(
              () -> {
                for (int i = 0; i < 10_000_000; i++) {
                  session.pins().pulse(0, i % 2 == 0 ? 1.4e-3 : 1.6e-3);
                }
              })
          .as("what piles up ends the connection")
          .isInstanceOf(ConnectionLostException.class);
      server.hold(false);
    }
  }
}
