package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.sim.ioio.IoioInProcess;
import org.u2sa.testkit.ServiceKit;

/** The service with the unmodified library and a simulated board on a bench, in lockstep. */
final class BoardKit implements AutoCloseable {
  static final double NEUTRAL_S = 1.5e-3;
  static final double RESOLUTION_S = 0.125e-6;
  static final int LEFT = 10;
  static final int RIGHT = 11;

  final Bench bench = new Bench();
  final IoioInProcess board = new IoioInProcess(bench.firmware);
  final ServiceKit kit = new ServiceKit();

  /** With the radio at automatic. */
  BoardKit() {
    bench.pulses(35, 1.9e-3);
    bench.volts(40, 2.4);
  }

  /** Starts the service and lets it connect. */
  IoioService start() {
    kit.with("GPS RECEIVER", "NMEA").with("COMPASS", "NMEA");
    IoioService service =
        kit.start(context -> new IoioService(context, BoardConnectorTest.connection(board)));
    kit.advance(0.2);
    return service;
  }

  /** Commands one actuator. */
  void command(String name, double percent) {
    kit.publish(Channels.ACTUATION, new PercentageCommand().actuatorName(name).percentage(percent));
  }

  /** Commands one actuator for a time. */
  void command(String name, double percent, double holdsS) {
    PercentageCommand command = new PercentageCommand().actuatorName(name).percentage(percent);
    command.expiry(holdsS);
    kit.publish(Channels.ACTUATION, command);
  }

  /** Commands both motors for a while, as control does. */
  void drive(double left, double right, double seconds) {
    for (double spent = 0.0; spent < seconds; spent += 0.1) {
      command("LEFT MOTOR", left);
      command("RIGHT MOTOR", right);
      kit.advance(0.1);
    }
  }

  void expectWidths(double leftS, double rightS) {
    assertThat(bench.width(LEFT)).isCloseTo(leftS, within(RESOLUTION_S));
    assertThat(bench.width(RIGHT)).isCloseTo(rightS, within(RESOLUTION_S));
  }

  Optional<String> lastError() {
    return kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError);
  }

  @Override
  public void close() {
    kit.close();
    LibraryThreads.awaitNone();
  }
}
