package org.u2sa.sim.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.Surface;
import org.u2sa.sim.world.World;

class SkidSteerVehicleTest {
  private static final Geodetic PLACE = new Geodetic(9.0, 54.0, 0.0);

  private static SkidSteerParameters parameters(double cogAheadM, Double... axles) {
    return new SkidSteerParameters(
        35.0,
        2.2,
        cogAheadM,
        0.18,
        List.of(axles),
        0.5,
        0.1,
        0.005,
        0.0,
        MotorParameters.pg27(),
        TyreParameters.wheelbarrow(),
        BatteryParameters.leadAcid7Ah(),
        Footprint.rectangle(0.5, 0.5, 0.6, 0.0, 0.5));
  }

  private static SkidSteerVehicle sixWheels() {
    return new SkidSteerVehicle(parameters(0.0, 0.32, 0.0, -0.32), GroundStart.atOrigin());
  }

  private static GroundState driven(SkidSteerVehicle vehicle, double left, double right) {
    vehicle.step(new DriveCommand(left, right), 5.0);
    return vehicle.state();
  }

  @Test
  void step_bothSidesAlike_drivesStraightAhead() {
    GroundState state = driven(sixWheels(), 1.0, 1.0);

    assertThat(state.eastM()).isZero();
    assertThat(state.headingRad()).isZero();
    assertThat(state.forwardMps()).isBetween(1.9, 2.1);
  }

  @Test
  void step_oppositeSides_turnsOnTheSpotMoreSlowlyThanTheWheelsRoll() {
    SkidSteerVehicle vehicle = sixWheels();
    GroundState state = driven(vehicle, 0.5, -0.5);
    double rolling = 2.0 * state.leftWheelRadPerS() * 0.1 / 0.5; // without side slip

    assertThat(Math.hypot(state.eastM(), state.northM())).isLessThan(0.01);
    assertThat(state.yawRateRadPerS()).isBetween(0.2 * rolling, 0.9 * rolling);
  }

  @Test
  void step_mirroredCommands_driveTheMirroredPath() {
    GroundState one = driven(sixWheels(), 0.8, 0.4);
    GroundState other = driven(sixWheels(), 0.4, 0.8);

    assertThat(other.eastM()).isCloseTo(-one.eastM(), within(1e-9));
    assertThat(other.northM()).isCloseTo(one.northM(), within(1e-9));
  }

  @Test
  void step_moreGrip_turnsMoreSlowly() {
    SkidSteerVehicle slippery = sixWheels();
    slippery.enter(World.at(PLACE).with(Surface.even(0.3, 0.05)));
    SkidSteerVehicle gripping = sixWheels();
    gripping.enter(World.at(PLACE).with(Surface.even(1.0, 0.05)));

    assertThat(driven(slippery, 0.5, -0.5).yawRateRadPerS())
        .isGreaterThan(driven(gripping, 0.5, -0.5).yawRateRadPerS());
  }

  @Test
  void step_tenWheels_isAsFastAsFour() {
    SkidSteerVehicle four =
        new SkidSteerVehicle(parameters(0.0, 0.3, -0.3), GroundStart.atOrigin());
    SkidSteerVehicle ten =
        new SkidSteerVehicle(parameters(0.0, 0.4, 0.2, 0.0, -0.2, -0.4), GroundStart.atOrigin());

    assertThat(driven(ten, 1.0, 1.0).forwardMps())
        .isCloseTo(driven(four, 1.0, 1.0).forwardMps(), within(0.15));
  }

  @Test
  void construct_gravityCentreBeyondTheAxles_isRefused() {
    assertThatThrownBy(
            () -> new SkidSteerVehicle(parameters(0.5, 0.3, -0.3), GroundStart.atOrigin()))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("axle -0.3 m: its wheels would carry -");
  }
}
