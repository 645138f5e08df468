package org.u2sa.sim.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Ramp;
import org.u2sa.sim.world.RampedGround;
import org.u2sa.sim.world.Terrain;
import org.u2sa.sim.world.World;

class SlopeTest {
  private static final double UP_NORTH = 0.0;
  private static final Geodetic HERE = new Geodetic(0.0, 0.0, 0.0);

  private static DifferentialVehicle molle(Terrain terrain, double headingRad) {
    DifferentialVehicle vehicle =
        new DifferentialVehicle(
            DifferentialParameters.miniMolle(), new GroundStart(0.0, 0.0, headingRad));
    vehicle.enter(World.at(HERE).with(terrain));
    return vehicle;
  }

  @Test
  void step_levelTerrain_isToTheBitWhatItIsWithout() {
    DifferentialVehicle without = new DifferentialVehicle(DifferentialParameters.miniMolle());
    DifferentialVehicle level = molle(Terrain.flat(), 0.0);
    DifferentialVehicle zero = molle(Terrain.slope(0.0, 1.0), 0.0);
    for (DifferentialVehicle vehicle : new DifferentialVehicle[] {without, level, zero}) {
      vehicle.step(new DriveCommand(0.6, 0.4), 7.0);
      vehicle.step(new DriveCommand(-0.3, 0.5), 2.0);
      vehicle.step(DriveCommand.neutral(), 3.0);
    }
    assertThat(level.state()).isEqualTo(without.state());
    assertThat(zero.state()).isEqualTo(without.state());
  }

  @ParameterizedTest
  @ValueSource(doubles = {6.0, 10.0})
  void step_coastingDownhill_gainsWhatGravityLeavesOfFriction(double slopeDeg) {
    double slope = Math.toRadians(slopeDeg);
    DifferentialParameters p = DifferentialParameters.miniMolle();
    DifferentialVehicle vehicle = molle(Terrain.slope(slope, UP_NORTH), Math.PI); // looks down
    vehicle.step(DriveCommand.none(), 1.0);
    double before = vehicle.state().forwardMps();
    vehicle.step(DriveCommand.none(), 1.0);
    double r = p.wheelRadiusM();
    double pull = p.massKg() * Gravity.STANDARD_MPS2 * Math.sin(slope);
    double resistance =
        0.05 * p.massKg() * Gravity.STANDARD_MPS2 * Math.cos(slope) + 2.0 * p.motor().dragNm() / r;
    double inertia = p.wheelInertiaKgM2() + p.motor().inertiaKgM2();
    double acceleration = (pull - resistance) / (p.massKg() + 2.0 * inertia / (r * r));
    assertThat(vehicle.state().forwardMps() - before)
        .isCloseTo(acceleration, within(0.05 * acceleration + 0.02));
  }

  @Test
  void step_gentleSlope_frictionHoldsTheVehicle() {
    DifferentialVehicle vehicle = molle(Terrain.slope(Math.toRadians(2.0), UP_NORTH), 0.0);
    vehicle.step(DriveCommand.neutral(), 10.0);
    assertThat(vehicle.state().northM()).isCloseTo(0.0, within(0.01));
  }

  @Test
  void step_fullCommandsUphill_isSlowerThanOnTheLevelAndThatThanDownhill() {
    Terrain slope = Terrain.slope(Math.toRadians(10.0), UP_NORTH);
    double up = speed(molle(slope, 0.0));
    double level = speed(molle(Terrain.flat(), 0.0));
    double down = speed(molle(slope, Math.PI));
    // 34 N of gravity, on motors that give 82 N less for each m/s
    assertThat(level - up).isBetween(0.3, 0.7);
    assertThat(down - level).isBetween(0.3, 0.7);
  }

  private static double speed(DifferentialVehicle vehicle) {
    vehicle.step(new DriveCommand(1.0, 1.0), 5.0);
    return vehicle.state().forwardMps();
  }

  @Test
  void step_slopeFromTheSide_turnsTheVehicleDownhill() {
    DifferentialVehicle vehicle =
        molle(Terrain.slope(Math.toRadians(10.0), UP_NORTH), Math.toRadians(90.0)); // looks east
    vehicle.step(new DriveCommand(0.5, 0.5), 2.0);
    assertThat(vehicle.state().headingRad()).isGreaterThan(Math.toRadians(91.0)); // to the south
  }

  @Test
  void step_truckUphill_losesSpeedAndKeepsBothAxlesLoaded() {
    AckermannVehicle truck = Truck.vehicle();
    truck.enter(World.at(HERE).with(Terrain.slope(Math.toRadians(10.0), UP_NORTH)));
    truck.step(new DriveCommand(0.8, 0.0), 5.0);
    AckermannVehicle level = Truck.vehicle();
    level.step(new DriveCommand(0.8, 0.0), 5.0);
    assertThat(truck.state().forwardMps()).isBetween(0.3, level.state().forwardMps() - 0.1);
  }

  @Test
  void hill_rises_areTheSlopeOfItsHeight() {
    Terrain hill = Terrain.hill(5.0, -3.0, 20.0, Math.toRadians(10.0));
    double step = 1.0e-4;
    for (double[] at : new double[][] {{5, -3}, {12, 1}, {-8, -10}, {25.1, -3}, {40, 40}}) {
      assertThat(hill.riseEast(at[0], at[1]))
          .isCloseTo(
              (hill.heightM(at[0] + step, at[1]) - hill.heightM(at[0] - step, at[1])) / 2.0 / step,
              within(1.0e-4));
      assertThat(hill.riseNorth(at[0], at[1]))
          .isCloseTo(
              (hill.heightM(at[0], at[1] + step) - hill.heightM(at[0], at[1] - step)) / 2.0 / step,
              within(1.0e-4));
    }
    assertThat(hill.riseEast(-5.0, -3.0)).isCloseTo(Math.tan(Math.toRadians(10.0)), within(1e-9));
    assertThat(hill.heightM(40.0, 40.0)).isZero();
  }

  @Test
  void step_overARamp_pitchesUpAndDownAndIsLevelBehindIt() {
    Ramp ramp =
        new Ramp(
            List.of(
                Point.of(0.0, 1.0, 0.0),
                Point.of(0.0, 3.0, 0.3),
                Point.of(0.0, 4.0, 0.3),
                Point.of(0.0, 6.0, 0.0)),
            3.0);
    DifferentialVehicle vehicle = molle(new RampedGround(List.of(ramp)), 0.0);
    double up = 0.0;
    double down = 0.0;
    double high = 0.0;
    double fastestRad = 0.0;
    while (vehicle.state().northM() < 7.0 && vehicle.state().timeS() < 20.0) {
      vehicle.step(new DriveCommand(0.7, 0.7), 0.01);
      VehicleTruth truth = vehicle.truth();
      up = Math.max(up, truth.attitude().theta());
      down = Math.min(down, truth.attitude().theta());
      high = Math.max(high, truth.position().z());
      fastestRad = Math.max(fastestRad, Math.abs(truth.rates().y()));
    }
    assertThat(vehicle.state().northM()).isGreaterThan(6.9);
    assertThat(up).isCloseTo(Math.atan(0.15), within(1.0e-6));
    assertThat(down).isCloseTo(-Math.atan(0.15), within(1.0e-6));
    assertThat(high).isCloseTo(0.3, within(1.0e-6));
    assertThat(vehicle.truth().attitude().theta()).isZero();
    assertThat(fastestRad).as("edges are as long as its wheelbase").isLessThan(1.0);
  }

  @Test
  void slope_tooSteep_isRefused() {
    assertThatThrownBy(() -> Terrain.slope(0.6, 0.0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("slope: 0.6 is outside 0.0…0.5");
  }
}
