package org.u2sa.sim.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class GroundDeterminismTest {
  static List<Supplier<GroundVehicle>> vehicles() {
    return List.of(
        () -> new DifferentialVehicle(DifferentialParameters.miniMolle()), () -> Truck.vehicle());
  }

  @ParameterizedTest
  @MethodSource("vehicles")
  void step_manySmallSteps_equalOneLarge(Supplier<GroundVehicle> maker) {
    GroundVehicle small = maker.get();
    GroundVehicle large = maker.get();
    DriveCommand command = new DriveCommand(0.6, 0.3);
    for (int i = 0; i < 1_000; i++) {
      small.step(command, 0.01);
    }
    large.step(command, 10.0);
    assertThat(small.state()).isEqualTo(large.state());
    assertThat(small.state().timeS()).isEqualTo(10.0);
  }

  @ParameterizedTest
  @MethodSource("vehicles")
  void step_stepsThatAreNoTicks_loseNoTime(Supplier<GroundVehicle> maker) {
    GroundVehicle vehicle = maker.get();
    for (int i = 0; i < 3_000; i++) {
      vehicle.step(DriveCommand.neutral(), 0.0005);
    }
    assertThat(vehicle.state().timeS()).isEqualTo(1.5);
  }

  @ParameterizedTest
  @MethodSource("vehicles")
  void step_restAndGoOn_isAsIfItHadNotRested(Supplier<GroundVehicle> maker) {
    GroundVehicle once = maker.get();
    GroundVehicle twice = maker.get();
    once.step(new DriveCommand(0.5, 0.2), 3.0);
    twice.step(DriveCommand.none(), 20.0);
    double restedAt = twice.state().northM();
    twice.step(new DriveCommand(0.5, 0.2), 3.0);
    assertThat(restedAt).isZero();
    assertThat(twice.state().northM())
        .isEqualTo(
            once.state().northM(),
            org.assertj.core.api.Assertions.within(
                1e-3)); // the battery has given a little meanwhile
  }

  @Test
  void step_zeroOrEndlessTime_isRefused() {
    GroundVehicle vehicle = vehicles().get(0).get();
    for (double dtS : new double[] {0.0, -1.0, 61.0, Double.NaN}) {
      assertThatThrownBy(() -> vehicle.step(DriveCommand.none(), dtS))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage("dt: " + dtS + " s is outside 0…60.0 s");
    }
  }
}
