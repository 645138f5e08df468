package org.u2sa.sim.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.sim.world.Surface;

/** The differential vehicle against what mechanics and the motor's equations say. */
class GroundPhysicsTest {
  private static final BatteryParameters STIFF = new BatteryParameters(12.0, 12.0, 0.0, 7.0, 0.0);
  private final DifferentialParameters parameters = DifferentialParameters.miniMolle();
  private final MotorParameters motor = parameters.motor();
  private final double wheel =
      (parameters.wheelInertiaKgM2() + motor.inertiaKgM2())
          / (parameters.wheelRadiusM() * parameters.wheelRadiusM());
  private final double movedKg = parameters.massKg() + 2.0 * wheel;

  @Test
  void step_commandRises_followsWithTheMotorsTimeConstant() {
    DifferentialVehicle vehicle = new DifferentialVehicle(parameters.withBattery(STIFF));
    vehicle.step(new DriveCommand(0.30, 0.30), 6.0);
    double first = vehicle.state().forwardMps();
    // τ = m r² / (2 η K² / R)
    double perWheel = motor.efficiency() * motor.constant() * motor.constant();
    double r = parameters.wheelRadiusM();
    double tauS = movedKg * r * r / (2.0 * perWheel / motor.resistanceOhm());
    vehicle.step(new DriveCommand(0.40, 0.40), tauS);
    double after = vehicle.state().forwardMps();
    vehicle.step(new DriveCommand(0.40, 0.40), 6.0);
    double last = vehicle.state().forwardMps();
    assertThat(tauS).isBetween(0.25, 0.35);
    assertThat((after - first) / (last - first))
        .isCloseTo(1.0 - Math.exp(-1.0), within(0.03)); // tyres and friction add a little
  }

  @Test
  void step_steadySpeed_isWhereTheMotorsTorqueMeetsTheResistance() {
    DifferentialVehicle vehicle = new DifferentialVehicle(parameters.withBattery(STIFF));
    vehicle.step(new DriveCommand(0.5, 0.5), 8.0);
    GroundState s = vehicle.state();
    double resistanceNm =
        0.05 * parameters.massKg() * Gravity.STANDARD_MPS2 * parameters.wheelRadiusM() / 2.0
            + motor.dragNm();
    double ampere = resistanceNm / (motor.constant() * motor.efficiency());
    assertThat(s.leftMotorA()).isCloseTo(ampere, within(0.01 * ampere));
    double spin = (0.5 * 12.0 - ampere * motor.resistanceOhm()) / motor.constant();
    assertThat(s.leftWheelRadPerS()).isCloseTo(spin, within(0.01 * spin));
  }

  @Test
  void step_fullCommandFromRest_isNoFasterThanTheGripAllows() {
    DifferentialVehicle vehicle = new DifferentialVehicle(parameters);
    vehicle.step(new DriveCommand(1.0, 1.0), 0.2);
    double share = 1.0 - parameters.cogAheadM() / parameters.castorAheadM(); // on driven wheels
    double fastest = 0.65 * share * Gravity.STANDARD_MPS2;
    GroundState s = vehicle.state();
    assertThat(s.forwardMps()).isBetween(0.8 * fastest * 0.2, fastest * 0.2);
    assertThat(s.leftWheelRadPerS() * parameters.wheelRadiusM()).isGreaterThan(s.forwardMps());
  }

  @Test
  void step_turnsOnTheSpot_isPulledForwardByItsCentreOfGravity() {
    DifferentialVehicle vehicle = new DifferentialVehicle(parameters.withBattery(STIFF));
    vehicle.step(new DriveCommand(0.3, -0.3), 6.0);
    GroundState s = vehicle.state();
    assertThat(s.yawRateRadPerS()).isGreaterThan(1.5);
    // m r² a pulls; the motors' back EMF holds, η K² / R at each wheel
    double pull =
        parameters.massKg() * s.yawRateRadPerS() * s.yawRateRadPerS() * parameters.cogAheadM();
    double damping = 2.0 * motor.constant() * motor.constant() / motor.resistanceOhm() / 0.01;
    assertThat(s.forwardMps()).isBetween(0.5 * pull / damping, 1.6 * pull / damping);
  }

  @Test
  void push_coastingOnIce_changesTheMomentumByForceTimesTime() {
    DifferentialVehicle vehicle = new DifferentialVehicle(parameters);
    vehicle.enter(vehicle.world().with(Surface.even(0.01, 0.0)));
    vehicle.push(100.0, 0.0, 0.0);
    vehicle.step(DriveCommand.none(), 0.5);
    double friction = 0.01 * parameters.massKg() * Gravity.STANDARD_MPS2; // at most
    double momentum = parameters.massKg() * vehicle.state().eastMps();
    assertThat(momentum).isBetween((100.0 - friction) * 0.5, 100.0 * 0.5);
  }

  @Test
  void push_parkedVehicle_holdsUntilTheFrictionGivesWay() {
    DifferentialVehicle vehicle = new DifferentialVehicle(parameters);
    vehicle.push(30.0, 0.0, 0.0); // from the side: the tyres hold 0.65 of their load
    vehicle.step(DriveCommand.neutral(), 5.0);
    assertThat(vehicle.state().eastM()).isLessThan(0.02);
    vehicle.push(0.0, 0.0, 0.0);
    vehicle.step(DriveCommand.neutral(), 1.0);
    assertThat(vehicle.state().speedMps()).isZero();
  }

  @Test
  void step_wholeDrive_energyComesFromTheBatteryAndGoesToHeat() {
    DifferentialVehicle vehicle = new DifferentialVehicle(parameters.withBattery(STIFF));
    vehicle.step(new DriveCommand(1.0, 1.0), 3.0);
    GroundState fast = vehicle.state();
    double kinetic = 0.5 * movedKg * fast.forwardMps() * fast.forwardMps();
    double taken = (1.0 - fast.charge()) * 7.0 * 3600.0 * 12.0;
    assertThat(kinetic).isBetween(0.1 * taken, 0.5 * taken);
    vehicle.step(DriveCommand.neutral(), 5.0);
    assertThat(vehicle.state().charge()).isEqualTo(fast.charge()); // shorted motors: all heat
    assertThat(vehicle.state().speedMps()).isZero();
  }

  @Test
  void state_underLoad_batterySags() {
    DifferentialVehicle vehicle = new DifferentialVehicle(parameters);
    vehicle.step(new DriveCommand(1.0, 1.0), 0.02);
    GroundState s = vehicle.state();
    double current = s.leftMotorA() + s.rightMotorA();
    assertThat(current).isGreaterThan(20.0);
    double expected = 12.8 - 0.043 * (current + 0.5);
    assertThat(s.batteryV()).isCloseTo(expected, within(0.1)); // the current of a tick before
  }

  @Test
  void step_payload_slowsTheStartAndChangesTheTurn() {
    DifferentialVehicle empty = new DifferentialVehicle(parameters);
    DifferentialVehicle laden =
        new DifferentialVehicle(parameters.withPayload(new Payload(10.0, 0.15, 0.12)));
    for (DifferentialVehicle vehicle : new DifferentialVehicle[] {empty, laden}) {
      vehicle.step(new DriveCommand(0.5, 0.5), 1.0);
    }
    assertThat(laden.state().northM()).isLessThan(0.95 * empty.state().northM());
    assertThat(empty.state().yawRateRadPerS()).isZero();
    assertThat(laden.state().yawRateRadPerS()).isPositive(); // the right wheel rolls harder
  }

  @Test
  void charge_emptyBattery_stopsTheVehicle() {
    DifferentialVehicle vehicle = new DifferentialVehicle(parameters);
    vehicle.charge(0.0);
    vehicle.step(new DriveCommand(1.0, 1.0), 2.0);
    assertThat(vehicle.state().northM()).isZero();
    assertThat(vehicle.state().batteryV()).isZero();
  }
}
