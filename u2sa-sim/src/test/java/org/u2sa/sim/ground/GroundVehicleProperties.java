package org.u2sa.sim.ground;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.stream.DoubleStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.u2sa.sim.world.Surface;

class GroundVehicleProperties {
  private static final double STEP_S = 0.1;
  private static final int STEPS = 100;

  @Property(tries = 40)
  void step_anyCommandsToADifferential_givesNumbersAndStaysSlow(
      @ForAll long seed,
      @ForAll @DoubleRange(min = 0.0, max = 15.0) double payloadKg,
      @ForAll @DoubleRange(min = -0.05, max = 0.3) double aheadM,
      @ForAll @DoubleRange(min = 0.02, max = 1.2) double grip) {
    DifferentialParameters parameters =
        DifferentialParameters.miniMolle().withPayload(new Payload(payloadKg, aheadM, 0.05));
    wild(new DifferentialVehicle(parameters), seed, grip);
  }

  @Property(tries = 40)
  void step_anyCommandsToAnAckermann_givesNumbersAndStaysSlow(
      @ForAll long seed,
      @ForAll @DoubleRange(min = 0.0, max = 2.0) double payloadKg,
      @ForAll @DoubleRange(min = 0.02, max = 1.2) double grip) {
    AckermannParameters parameters = Truck.with(new Payload(payloadKg, 0.1, 0.0));
    wild(Truck.vehicle(parameters), seed, grip);
  }

  @Property(tries = 20)
  void step_mirroredCommands_mirrorsADifferentialToTheLastBit(@ForAll long seed) {
    DifferentialParameters parameters = DifferentialParameters.miniMolle();
    Payload right = new Payload(3.0, 0.1, 0.08);
    Payload left = new Payload(3.0, 0.1, -0.08);
    mirrored(
        new DifferentialVehicle(parameters.withPayload(right)),
        new DifferentialVehicle(parameters.withPayload(left)),
        seed,
        command -> new DriveCommand(command.second(), command.first()));
  }

  @Property(tries = 20)
  void step_mirroredCommands_mirrorsAnAckermannToTheLastBit(@ForAll long seed) {
    mirrored(
        Truck.vehicle(),
        Truck.vehicle(),
        seed,
        command -> new DriveCommand(command.first(), -command.second()));
  }

  private static void wild(GroundVehicle vehicle, long seed, double grip) {
    Random driver = new Random(seed);
    vehicle.enter(vehicle.world().with(Surface.even(grip, 0.05)));
    for (int i = 0; i < STEPS; i++) {
      vehicle.step(anyCommand(driver), STEP_S);
      GroundState s = vehicle.state();
      assertThat(numbers(s).allMatch(Double::isFinite)).as("%s", s).isTrue();
      assertThat(s.headingRad()).isGreaterThanOrEqualTo(0.0).isLessThan(2.0 * Math.PI);
      assertThat(s.speedMps()).isLessThan(4.0);
      assertThat(Math.abs(s.yawRateRadPerS())).isLessThan(15.0);
      assertThat(s.batteryV()).isBetween(9.0, 13.5); // reversing at full speed, braking at half
    }
  }

  private static void mirrored(
      GroundVehicle vehicle,
      GroundVehicle image,
      long seed,
      java.util.function.UnaryOperator<DriveCommand> mirror) {
    Random driver = new Random(seed);
    for (int i = 0; i < STEPS; i++) {
      DriveCommand command = anyCommand(driver);
      vehicle.step(command, STEP_S);
      image.step(mirror.apply(command), STEP_S);
      GroundState s = vehicle.state();
      GroundState m = image.state();
      assertThat(m.eastM()).isEqualTo(-s.eastM());
      assertThat(m.northM()).isEqualTo(s.northM());
      assertThat(m.forwardMps()).isEqualTo(s.forwardMps());
      assertThat(m.rightMps()).isEqualTo(-s.rightMps());
      assertThat(m.yawRateRadPerS()).isEqualTo(-s.yawRateRadPerS());
      assertThat(m.batteryV()).isEqualTo(s.batteryV());
    }
  }

  private static DriveCommand anyCommand(Random driver) {
    if (driver.nextInt(10) == 0) {
      return DriveCommand.none();
    }
    return new DriveCommand(2.0 * driver.nextDouble() - 1.0, 2.0 * driver.nextDouble() - 1.0);
  }

  private static DoubleStream numbers(GroundState s) {
    return DoubleStream.of(
        s.timeS(),
        s.eastM(),
        s.northM(),
        s.headingRad(),
        s.forwardMps(),
        s.rightMps(),
        s.yawRateRadPerS(),
        s.leftWheelRadPerS(),
        s.rightWheelRadPerS(),
        s.leftWheelRad(),
        s.rightWheelRad(),
        s.steerRad(),
        s.leftMotorA(),
        s.rightMotorA(),
        s.batteryV(),
        s.charge());
  }
}
