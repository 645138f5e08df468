package org.u2sa.drivers.ioio;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.sim.ground.MiniMolle;
import org.u2sa.sim.ioio.IoioBoard;
import org.u2sa.sim.ioio.IoioFirmware;
import org.u2sa.sim.ioio.IoioInProcess;
import org.u2sa.sim.world.World;
import org.u2sa.testkit.ServiceKit;

/** The whole chain: vehicle, firmware, library, drivers, service. The same twice, and fast. */
class LockstepRunTest {
  private static final double RUN_S = 60.0;
  private static final double COMMAND_EVERY_S = 0.1;
  private static final Geodetic HOME = new Geodetic(-78.67, 35.78, 100.0);

  /** What a run left behind. */
  private record Outcome(List<String> states, List<String> power, String place, double tookS) {}

  @AfterEach
  void noThreadIsLeft() {
    LibraryThreads.awaitNone();
  }

  private static Outcome run(long seed) {
    MiniMolle vehicle = MiniMolle.in(World.at(HOME)).seed(seed).build();
    IoioInProcess board = new IoioInProcess(new IoioFirmware(IoioBoard.OTG, vehicle));
    Clock watch = new SystemClock();
    try (ServiceKit kit = new ServiceKit().seed(seed)) {
      kit.start(context -> new IoioService(context, BoardConnectorTest.connection(board)));
      long began = watch.micros();
      for (double spent = 0.0; spent < RUN_S; spent += COMMAND_EVERY_S) {
        double turn = 20.0 * Math.sin(spent / 5.0);
        command(kit, "LEFT MOTOR", 50.0 + turn);
        command(kit, "RIGHT MOTOR", 50.0 - turn);
        kit.advance(COMMAND_EVERY_S);
      }
      double tookS = Clock.seconds(watch.micros() - began);
      assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError)).isEmpty();
      return new Outcome(
          kit.published(Channels.SENSED_STATE).stream().map(Object::toString).toList(),
          kit.published(Channels.POWER).stream().map(Object::toString).toList(),
          vehicle.truth().toString(),
          tookS);
    }
  }

  private static void command(ServiceKit kit, String name, double percent) {
    kit.publish(Channels.ACTUATION, new PercentageCommand().actuatorName(name).percentage(percent));
  }

  @Test
  void run_sameSeedTwice_sameMessages() {
    Outcome first = run(7);
    Outcome second = run(7);
    System.out.printf(
        "IOIO in lockstep: %.0f s of the run in %.2f s, %.0f x real time, %d states%n",
        RUN_S, second.tookS(), RUN_S / second.tookS(), second.states().size());
    assertThat(first.states().size()).isGreaterThan(500);
    assertThat(second.states()).isEqualTo(first.states());
    assertThat(second.power()).isEqualTo(first.power());
    assertThat(second.place()).isEqualTo(first.place());
    assertThat(first.place()).doesNotContain("position=(0.0, 0.0");
  }
}
