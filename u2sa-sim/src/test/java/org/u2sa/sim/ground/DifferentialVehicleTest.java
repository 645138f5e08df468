package org.u2sa.sim.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Gravity;

class DifferentialVehicleTest {
  private final DifferentialParameters parameters = DifferentialParameters.miniMolle();
  private final DifferentialVehicle vehicle = new DifferentialVehicle(parameters);

  @Test
  void step_equalCommands_drivesStraightNorth() {
    vehicle.step(new DriveCommand(0.7, 0.7), 20.0);
    GroundState s = vehicle.state();
    assertThat(s.northM()).isGreaterThan(20.0);
    assertThat(s.eastM()).isZero();
    assertThat(s.headingRad()).isZero();
  }

  @Test
  void step_fullCommands_reachesAWalkersPace() {
    vehicle.step(new DriveCommand(1.0, 1.0), 5.0);
    assertThat(vehicle.state().forwardMps()).isBetween(1.5, 2.1);
  }

  @Test
  void step_leftFaster_turnsRight() {
    vehicle.step(new DriveCommand(0.6, 0.4), 1.0);
    assertThat(vehicle.state().yawRateRadPerS()).isPositive();
    assertThat(vehicle.state().eastM()).isPositive();
  }

  @Test
  void step_slowCurve_hasTheRadiusOfItsWheelSpeeds() {
    vehicle.step(new DriveCommand(0.4, 0.35), 8.0);
    GroundState s = vehicle.state();
    double left = s.leftWheelRadPerS();
    double right = s.rightWheelRadPerS();
    // R = b/2 · (ωl + ωr) / (ωl − ωr), without slip (Siegwart, Autonomous Mobile Robots, eq. 3.10)
    double radius = parameters.trackM() / 2.0 * (left + right) / (left - right);
    assertThat(s.forwardMps() / s.yawRateRadPerS()).isCloseTo(radius, within(0.05 * radius));
  }

  @Test
  void step_noPulses_coastsAsFarAsItsFrictionSays() {
    vehicle.step(new DriveCommand(0.6, 0.6), 6.0);
    GroundState before = vehicle.state();
    vehicle.step(DriveCommand.none(), 10.0);
    MotorParameters motor = parameters.motor();
    double r = parameters.wheelRadiusM();
    double resistance =
        0.05 * parameters.massKg() * Gravity.STANDARD_MPS2 + 2.0 * motor.dragNm() / r;
    double inertia = parameters.wheelInertiaKgM2() + motor.inertiaKgM2();
    double mass = parameters.massKg() + 2.0 * inertia / (r * r);
    double distance = mass * before.forwardMps() * before.forwardMps() / (2.0 * resistance);
    GroundState after = vehicle.state();
    assertThat(after.speedMps()).isZero();
    assertThat(after.northM() - before.northM()).isCloseTo(distance, within(0.03 * distance));
  }

  @Test
  void step_neutral_brakesMuchShorterThanItCoasts() {
    vehicle.step(new DriveCommand(0.6, 0.6), 6.0);
    double before = vehicle.state().northM();
    vehicle.step(DriveCommand.neutral(), 10.0);
    assertThat(vehicle.state().speedMps()).isZero();
    assertThat(vehicle.state().northM() - before).isBetween(0.1, 0.4);
  }

  @Test
  void step_smallCommand_doesNotOvercomeFriction() {
    vehicle.step(new DriveCommand(0.06, 0.06), 5.0);
    assertThat(vehicle.state().northM()).isLessThan(0.01);
  }

  @Test
  void step_withinTheDeadBand_drawsNoCurrent() {
    vehicle.step(new DriveCommand(0.04, -0.04), 1.0);
    assertThat(vehicle.state().leftMotorA()).isZero();
  }

  @Test
  void step_strongerRightMotor_driftsLeft() {
    DifferentialVehicle drifting = new DifferentialVehicle(parameters.withMismatch(0.02));
    drifting.step(new DriveCommand(0.5, 0.5), 5.0);
    assertThat(drifting.state().eastM()).isNegative();
  }

  @Test
  void new_payloadBehindTheAxle_isRefusedAsTheCastorLifts() {
    DifferentialParameters tipping = parameters.withPayload(new Payload(20.0, -0.5, 0.0));
    assertThatThrownBy(() -> new DifferentialVehicle(tipping))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("payload: the castor would carry -");
  }
}
