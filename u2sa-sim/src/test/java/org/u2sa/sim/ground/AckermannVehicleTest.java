package org.u2sa.sim.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.frame.Gravity;

class AckermannVehicleTest {
  private static final double CREEP = 0.15; // command for 0.1 m/s

  private final AckermannParameters parameters = Truck.with(Payload.none());
  private final AckermannVehicle vehicle = Truck.vehicle(parameters);

  @Test
  void step_straight_drivesStraightNorth() {
    vehicle.step(new DriveCommand(0.7, 0.0), 20.0);
    GroundState s = vehicle.state();
    assertThat(s.northM()).isGreaterThan(20.0);
    assertThat(s.eastM()).isZero();
    assertThat(s.headingRad()).isZero();
  }

  @ParameterizedTest
  @ValueSource(doubles = {-1.0, -0.4, 0.2, 0.6, 1.0})
  void step_atACrawl_hasTheRadiusOfTheKinematicBicycle(double steering) {
    vehicle.step(new DriveCommand(CREEP, steering), 10.0);
    GroundState s = vehicle.state();
    // R = L / tan δ, at the rear axle (Rajamani, eq. 2.10 with δr = 0)
    double radius = parameters.wheelbaseM() / Math.tan(parameters.steerMaxRad() * steering);
    assertThat(s.forwardMps() / s.yawRateRadPerS())
        .isCloseTo(radius, within(0.015 * Math.abs(radius)));
  }

  @Test
  void step_fasterInACurve_runsAtSlipAnglesThatCornerItsWeight() {
    vehicle.step(new DriveCommand(1.0, 0.5), 10.0);
    GroundState s = vehicle.state();
    double lateral = s.forwardMps() * s.yawRateRadPerS(); // [m/s²]
    double slip = Math.atan2(s.rightMps(), s.forwardMps()); // of the rear axle
    // across = stiffness · load · slip, and the rear axle corners its share of the weight
    double expected = -lateral / Gravity.STANDARD_MPS2 / parameters.tyre().slipStiffness();
    assertThat(lateral).isGreaterThan(1.0);
    assertThat(slip).isCloseTo(expected, within(0.1 * Math.abs(expected)));
  }

  @Test
  void step_steeringThrown_followsAtItsRateAndThenItsLag() {
    vehicle.step(new DriveCommand(0.0, 1.0), 0.05);
    double rate = parameters.steerRateRadPerS();
    assertThat(vehicle.state().steerRad()).isCloseTo(0.05 * rate, within(1e-6));
    vehicle.step(new DriveCommand(0.0, 1.0), 0.5);
    double before = parameters.steerMaxRad() - vehicle.state().steerRad();
    vehicle.step(new DriveCommand(0.0, 1.0), parameters.steerLagS());
    double after = parameters.steerMaxRad() - vehicle.state().steerRad();
    assertThat(after / before).isCloseTo(Math.exp(-1.0), within(0.01));
  }

  @Test
  void step_noPulses_leavesTheSteeringWhereItIsAndCoastsToRest() {
    vehicle.step(new DriveCommand(0.6, 0.5), 3.0);
    double steer = vehicle.state().steerRad();
    vehicle.step(DriveCommand.none(), 10.0);
    assertThat(vehicle.state().steerRad()).isEqualTo(steer);
    assertThat(vehicle.state().speedMps()).isZero();
  }

  @Test
  void step_reverse_steersTheOtherWay() {
    vehicle.step(new DriveCommand(-0.5, 1.0), 3.0);
    assertThat(vehicle.state().forwardMps()).isNegative();
    assertThat(vehicle.state().yawRateRadPerS()).isNegative();
  }

  @Test
  void new_payloadBehindTheRearAxle_isRefusedAsTheFrontLifts() {
    AckermannParameters tipping = Truck.with(new Payload(5.0, -0.3, 0.0));
    assertThatThrownBy(() -> Truck.vehicle(tipping))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("payload: the front axle would carry -");
  }
}
