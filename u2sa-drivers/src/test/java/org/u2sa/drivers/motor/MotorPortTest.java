package org.u2sa.drivers.motor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.device.WheelMotors;
import org.u2sa.device.port.MotorController;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.sim.device.SimulatedMotors;
import org.u2sa.sim.ground.DifferentialParameters;
import org.u2sa.sim.ground.DifferentialVehicle;
import org.u2sa.sim.ground.DriveCommand;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.testkit.DeviceContract;
import org.u2sa.testkit.ServiceKit;

/** Every motor controller, at rest; and a simulated vehicle driven through the port alone. */
class MotorPortTest extends DeviceContract<MotorController.Counts> {
  private static final double TIMEOUT_S = 0.3;

  @Override
  protected List<Bench<MotorController.Counts>> benches() {
    MemoryLink link = new MemoryLink();
    LinkedBench<MotorController.Counts> roboClaw =
        new LinkedBench<>(
            "RoboClaw", link, new RoboClaw(link, 128, TIMEOUT_S), Long.MAX_VALUE, line -> {});
    new SimulatedRoboClaw(link, roboClaw::nowMicros);
    DifferentialVehicle vehicle = new DifferentialVehicle(DifferentialParameters.miniMolle());
    return List.of(
        roboClaw,
        new SimulatedBench<>(
            "simulated",
            new SimulatedMotors(1000.0, TIMEOUT_S, new NoiseStreams(1), vehicle::state)));
  }

  @Override
  protected void judge(MotorController.Counts counts) {
    assertThat(counts.first()).isZero();
    assertThat(counts.second()).isZero();
    assertThat(counts.batteryV().orElse(12.0)).isBetween(10.0, 30.0);
  }

  @Test
  void wheelMotors_overSimulatedMotors_driveTheVehicleAndStopItWhenUnplugged() {
    DifferentialVehicle vehicle = new DifferentialVehicle(DifferentialParameters.miniMolle());
    SimulatedMotors motors =
        new SimulatedMotors(1000.0, TIMEOUT_S, new NoiseStreams(1), vehicle::state);
    try (ServiceKit kit = new ServiceKit()) {
      kit.with("COUNTS PER TURN", 1000.0);
      kit.with("WHEEL DIAMETER", 2.0 * DifferentialParameters.miniMolle().wheelRadiusM());
      kit.start(context -> new WheelMotors(context, motors));
      drive(kit, vehicle, motors, 3.0);
      double forwardMps = vehicle.state().forwardMps();
      assertThat(forwardMps).isGreaterThan(0.3);
      assertThat(kit.latest(Channels.SENSED_STATE).orElseThrow().xDot().orElseThrow())
          .isCloseTo(forwardMps, within(0.2 * forwardMps));

      motors.plug(false);
      drive(kit, vehicle, motors, 0.4);
      assertThat(motors.command(kit.clock().micros())).isEqualTo(DriveCommand.neutral());
    }
  }

  private static void drive(
      ServiceKit kit, DifferentialVehicle vehicle, SimulatedMotors motors, double seconds) {
    for (int i = 0; i < Math.round(seconds * 20.0); i++) {
      kit.publish(Channels.ACTUATION, PercentageCommand.of("LEFT MOTOR", 50.0));
      kit.publish(Channels.ACTUATION, PercentageCommand.of("RIGHT MOTOR", 50.0));
      kit.advance(0.05);
      vehicle.step(motors.command(kit.clock().micros()), 0.05);
    }
  }
}
