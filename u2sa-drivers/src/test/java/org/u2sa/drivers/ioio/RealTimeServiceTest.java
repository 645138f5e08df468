package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.Map;
import java.util.concurrent.Callable;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.ServiceContext;
import org.u2sa.sim.ioio.IoioTcpServer;

/** The service over TCP in real time: how long an emergency stop takes, and that it ends. */
class RealTimeServiceTest {
  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final double NEUTRAL_S = 1.5e-3;
  private static final double NEAR_S = 1.0e-6;
  private static final int STOPS = 20;
  private static final String SYSTEM = "test";

  private final Clock clock = new SystemClock();
  private final Bench bench = new Bench();
  private final IoioTcpServer server = new IoioTcpServer(bench.firmware, clock, 0);
  private final LocalBus bus = new LocalBus(SYSTEM);
  @TempDir private Path logs;

  @AfterEach
  void close() {
    server.close();
    LibraryThreads.awaitNone();
  }

  private IoioService service() {
    Map<String, Object> variables =
        Map.of(
            "CONNECTION",
            "tcp:127.0.0.1:" + server.port(),
            "BOARD SILENT AFTER",
            30.0,
            "COMMAND EXPIRY",
            30.0);
    return new IoioService(
        ServiceContext.of(SYSTEM, XmlConfiguration.inMemory("the test", variables))
            .clock(clock)
            .transport(bus)
            .logDirectory(logs)
            .build());
  }

  private <T extends U2SAData> void publish(Channel<T> channel, T message) {
    message.systemId(SYSTEM);
    message.timestamp(clock.micros());
    message.freeze();
    bus.deliver(channel, message);
  }

  private void drive() {
    for (String name : new String[] {"LEFT MOTOR", "RIGHT MOTOR"}) {
      publish(Channels.ACTUATION, new PercentageCommand().actuatorName(name).percentage(100.0));
    }
  }

  private void await(Callable<Boolean> condition) {
    Awaitility.await()
        .atMost(PATIENCE)
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(1))
        .until(condition);
  }

  private boolean isNeutral() {
    return Math.abs(bench.width(10) - NEUTRAL_S) < NEAR_S
        && Math.abs(bench.width(11) - NEUTRAL_S) < NEAR_S;
  }

  @Test
  void callback_emergencyStops_neutralPulsesAtThePinsAtOnce() {
    bench.pulses(35, 1.9e-3);
    IoioService service = service();
    service.start();
    long[] tookMicros = new long[STOPS];
    for (int i = 0; i < STOPS; i++) {
      await(
          () -> {
            drive();
            return bench.width(10) > 1.7e-3 && bench.width(11) > 1.7e-3;
          });
      long began = clock.micros();
      EmergencyStop stop = new EmergencyStop().active(true).operator("test");
      publish(Channels.EMERGENCY_STOP, stop);
      while (!isNeutral() && clock.micros() - began < PATIENCE.toMillis() * 1000) {
        Thread.onSpinWait();
      }
      tookMicros[i] = clock.micros() - began;
      assertThat(isNeutral()).isTrue();
      drive();
      assertThat(isNeutral()).as("stays so").isTrue();
      publish(
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
    await(() -> bench.width(10) == 0.0); // no pulses after the end
  }

  @Test
  void kill_boardThatHangs_endsAllTheSame() {
    IoioService service = service();
    service.start();
    await(() -> server.isConnected() && bench.level(0) != null && isNeutral());
    server.hold(true);
    service.kill();
    assertThat(service.isAlive()).isFalse();
    server.hold(false);
  }

  @Test
  void kill_boardThatIsNotThere_ends() {
    server.power(false);
    IoioService service = service();
    service.start();
    await(service::isAlive);
    service.kill();
    assertThat(service.isAlive()).isFalse();
  }
}
