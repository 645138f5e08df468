package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.sim.ioio.IoioTcpServer;
import org.u2sa.testkit.ServiceKit;

/**
 * A board over TCP that obeys and answers, but whose UARTs give no room: its clock stands still, so
 * that nothing leaves their lines.
 */
@Timeout(120) // a thread that waits for room waits forever
class UartWithoutRoomTest {
  private static final int BOARD_AND_LIBRARY = 256 + 1024; // bytes that fit without any room
  private static final int PACKET = 64;
  private static final long SECOND = 1_000_000;

  private final LockstepClock boardClock = new LockstepClock();
  private final Bench bench = new Bench();
  private final IoioTcpServer server = new IoioTcpServer(bench.firmware, boardClock, 0);
  private final ServiceKit kit = new ServiceKit();
  private long nowMicros;

  @AfterEach
  void close() {
    server.close();
    kit.close();
    LibraryThreads.awaitNone();
  }

  private BoardConnection connection() {
    return BoardConnection.of("tcp:127.0.0.1:" + server.port());
  }

  private static void awaitUntil(Callable<Boolean> isSo) {
    await().atMost(TcpBench.PATIENCE).pollInSameThread().until(isSo);
  }

  private BoardPins connected(BoardConnector connector) {
    connector.start();
    awaitUntil(
        () -> {
          connector.step(0);
          return connector.session().isPresent();
        });
    return connector.session().orElseThrow().pins();
  }

  /** Sends a second's worth of bytes at most. */
  private void send(UartLine line) throws IOException {
    nowMicros += SECOND;
    line.send(nowMicros, Optional.empty());
  }

  /**
   * Writes until the line is full; returns what was written. The library's own thread hands on what
   * the board still takes, whenever it runs, so that only this many bytes left mean full.
   */
  private byte[] fill(UartLine line) {
    byte[] bytes = new byte[2 * BOARD_AND_LIBRARY];
    for (int i = 0; i < bytes.length; i++) {
      bytes[i] = (byte) (i % 251);
    }
    line.write(bytes);
    awaitUntil(
        () -> {
          send(line);
          return line.isFull() && line.waiting() == bytes.length - BOARD_AND_LIBRARY;
        });
    return bytes;
  }

  @Test
  void send_boardGivesNoRoom_keepsTheRestAndPulsesArrive() throws Exception {
    try (BoardConnector connector = TcpBench.connector(connection())) {
      BoardPins pins = connected(connector);
      UartLine line = pins.gps().orElseThrow();
      fill(line);
      assertThat(Thread.currentThread().isInterrupted()).isFalse();
      pins.pulse(0, 1.6e-3);
      awaitUntil(() -> Math.abs(bench.width(10) - 1.6e-3) < TcpBench.RESOLUTION_S);
    }
  }

  @Test
  void send_boardGivesRoomAgain_allBytesArriveInOrder() throws Exception {
    try (BoardConnector connector = TcpBench.connector(connection())) {
      UartLine line = connected(connector).gps().orElseThrow();
      byte[] written = fill(line);
      awaitUntil(
          () -> {
            boardClock.advance(SECOND / 10);
            send(line);
            return bench.received(7).length >= written.length;
          });
      assertThat(bench.received(7)).isEqualTo(written);
      assertThat(line.isFull()).isFalse();
    }
  }

  @Test
  void send_interruptedThread_sendsAndStaysInterrupted() throws Exception {
    try (BoardConnector connector = TcpBench.connector(connection())) {
      UartLine line = connected(connector).gps().orElseThrow();
      line.write(new byte[PACKET]);
      Thread.currentThread().interrupt();
      send(line); // the first call only sets the time
      send(line);
      assertThat(Thread.interrupted()).isTrue();
      assertThat(line.waiting()).isZero();
    }
  }

  @Test
  void send_connectionHasEnded_throws() {
    try (BoardConnector connector = TcpBench.connector(connection())) {
      UartLine line = connected(connector).gps().orElseThrow();
      server.power(false);
      line.write(new byte[2 * BOARD_AND_LIBRARY]);
      await()
          .atMost(TcpBench.PATIENCE)
          .pollInSameThread()
          .untilAsserted(
              () -> assertThatThrownBy(() -> send(line)).isInstanceOf(IOException.class));
      assertThat(Thread.currentThread().isInterrupted()).isFalse();
    }
  }

  private void command(double percent) {
    for (String motor : List.of("LEFT MOTOR", "RIGHT MOTOR")) {
      kit.publish(Channels.ACTUATION, PercentageCommand.of(motor, percent));
    }
    kit.advance(0.1);
  }

  @Test
  void step_boardGivesNoRoom_isNamedAndEmergencyStopIsObeyed() {
    kit.with("RC SWITCH PIN", -1).with("BOARD SILENT AFTER", 60.0);
    kit.start(context -> new IoioService(context, connection()));
    awaitUntil(
        () -> {
          kit.advance(
              4.0); // the board's answers, of which some are needed a minute, take real time
          return kit.published(Channels.HEALTH).stream()
              .map(HealthReport::lastError)
              .anyMatch(Optional.of("the IOIO takes no bytes for the compass")::equals);
        });
    awaitUntil(
        () -> {
          command(60.0);
          return bench.width(10) > 1.7e-3 && bench.width(11) > 1.7e-3;
        });
    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(true).operator("test"));
    awaitUntil(
        () ->
            Math.abs(bench.width(10) - 1.5e-3) < TcpBench.RESOLUTION_S
                && Math.abs(bench.width(11) - 1.5e-3) < TcpBench.RESOLUTION_S);
  }
}
