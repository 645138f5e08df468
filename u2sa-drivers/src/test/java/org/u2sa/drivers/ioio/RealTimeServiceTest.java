package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.drivers.link.RealTime;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.sim.ioio.IoioTcpServer;

/** The service over TCP in real time: how long an emergency stop takes, and that it ends. */
class RealTimeServiceTest {
  private static final double NEUTRAL_S = 1.5e-3;
  private static final double NEAR_S = 1.0e-6;
  private static final long PATIENCE_MICROS = 30_000_000;
  private static final int STOPS = 20;

  private final Clock clock = new SystemClock();
  private final Bench bench = new Bench();
  private final IoioTcpServer server = new IoioTcpServer(bench.firmware, clock, 0);
  private RealTime on;
  private IoioService service;
  @TempDir private Path logs;

  @AfterEach
  void close() {
    server.close();
    LibraryThreads.awaitNone();
  }

  private void start() {
    on =
        new RealTime(logs)
            .with("CONNECTION", "tcp:127.0.0.1:" + server.port())
            .with("BOARD SILENT AFTER", 30.0)
            .with("COMMAND EXPIRY", 30.0);
    on.start(context -> service = new IoioService(context));
  }

  private void drive() {
    on.command("LEFT MOTOR", 100.0);
    on.command("RIGHT MOTOR", 100.0);
  }

  private boolean isNeutral() {
    return Math.abs(bench.width(10) - NEUTRAL_S) < NEAR_S
        && Math.abs(bench.width(11) - NEUTRAL_S) < NEAR_S;
  }

  @Test
  void callback_emergencyStops_neutralPulsesAtThePinsAtOnce() {
    bench.pulses(35, 1.9e-3);
    start();
    long[] tookMicros = new long[STOPS];
    for (int i = 0; i < STOPS; i++) {
      on.until(
          () -> {
            drive();
            return bench.width(10) > 1.7e-3 && bench.width(11) > 1.7e-3;
          });
      long began = clock.micros();
      EmergencyStop stop = new EmergencyStop().active(true).operator("test");
      on.send(Channels.EMERGENCY_STOP, stop);
      while (!isNeutral() && clock.micros() - began < PATIENCE_MICROS) {
        Thread.onSpinWait();
      }
      tookMicros[i] = clock.micros() - began;
      assertThat(isNeutral()).isTrue();
      drive();
      assertThat(isNeutral()).as("stays so").isTrue();
      on.send(
          Channels.EMERGENCY_STOP,
          new EmergencyStop()
              .active(false)
              .operator("test")
              .clears(stop.timestamp().orElseThrow()));
    }
    Arrays.sort(tookMicros);
    System.out.printf(
        "IOIO over TCP: from the emergency stop to neutral at the pins %d us (median), %d us (worst of %d)%n",
        tookMicros[STOPS / 2], tookMicros[STOPS - 1], STOPS);
    service.kill();
    on.until(() -> bench.width(10) == 0.0); // no pulses after the end
  }

  @Test
  void kill_boardThatHangs_endsAllTheSame() {
    start();
    on.until(() -> server.isConnected() && bench.level(0) != null && isNeutral());
    server.hold(true);
    service.kill();
    assertThat(service.isAlive()).isFalse();
    server.hold(false);
  }

  @Test
  void kill_boardThatIsNotThere_ends() {
    server.power(false);
    start();
    on.until(service::isAlive);
    service.kill();
    assertThat(service.isAlive()).isFalse();
  }
}
