package org.u2sa.sim.vehicle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.aircraft.RunwayStart;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.ground.DifferentialParameters;
import org.u2sa.sim.ground.DifferentialVehicle;
import org.u2sa.sim.ground.GroundStart;
import org.u2sa.sim.ground.GroundVehicle;
import org.u2sa.sim.ground.Truck;
import org.u2sa.sim.world.Terrain;
import org.u2sa.sim.world.World;

/** What every simulated vehicle promises, on each of them. */
class VehicleRunTest {
  private static final World LAWN = World.at(new Geodetic(11.0, 48.0, 500.0));

  static Stream<SimulatedVehicle> vehicles() {
    return Stream.of(
        new DifferentialVehicle(DifferentialParameters.miniMolle()),
        Truck.vehicle(),
        Cessna172.onRunway(new RunwayStart(11.0, 48.0, 500.0, 1.0), Wind.calm(), true));
  }

  private static void full(VehicleRun run, long nowMicros) {
    for (String actuator : run.vehicle().actuators()) {
      boolean drives = actuator.contains("MOTOR") || actuator.equals("THROTTLE");
      run.command(nowMicros, actuator, drives || actuator.equals("MIXTURE") ? 1.0 : 0.0);
    }
  }

  @ParameterizedTest
  @MethodSource("vehicles")
  void at_fullPower_movesAheadAndTruthIsConsistent(SimulatedVehicle vehicle) {
    VehicleRun run = new VehicleRun(vehicle);
    full(run, 7L);
    VehicleTruth before = run.at(2_000_007L);
    VehicleTruth after = run.at(2_100_007L);

    assertThat(after.timeS() - before.timeS()).isCloseTo(0.1, within(1e-9));
    assertThat(after.speedMps()).isGreaterThan(0.5);
    Point moved = after.position().minus(before.position());
    assertThat(moved.x() / 0.1)
        .isCloseTo((before.velocity().x() + after.velocity().x()) / 2.0, within(0.05));
    assertThat(moved.y() / 0.1)
        .isCloseTo((before.velocity().y() + after.velocity().y()) / 2.0, within(0.05));
    double gained = after.velocity().y() - before.velocity().y();
    double mean = (before.acceleration().y() + after.acceleration().y()) / 2.0;
    assertThat(gained / 0.1).isCloseTo(mean, within(0.3));
    assertThat(Math.atan2(moved.x(), moved.y())).isCloseTo(after.headingRad(), within(0.05));
  }

  @ParameterizedTest
  @MethodSource("vehicles")
  void at_clockJumpsByAnHour_goesOnFromThere(SimulatedVehicle vehicle) {
    VehicleRun run = new VehicleRun(vehicle);
    run.at(7L);

    assertThat(run.at(3_600_000_007L).timeS()).isCloseTo(60.0, within(0.01));
    assertThat(run.at(3_601_000_007L).timeS()).isCloseTo(61.0, within(0.01));
  }

  @ParameterizedTest
  @MethodSource("vehicles")
  void command_noSignal_isTaken(SimulatedVehicle vehicle) {
    VehicleRun run = new VehicleRun(vehicle);
    for (String actuator : vehicle.actuators()) {
      run.command(7L, actuator, Double.NaN);
    }

    assertThat(run.at(1_000_007L).speedMps()).isLessThan(0.1);
  }

  @ParameterizedTest
  @MethodSource("vehicles")
  void command_unknownActuator_isRefusedWithThoseThereAre(SimulatedVehicle vehicle) {
    assertThatThrownBy(() -> vehicle.command("SAIL", 0.0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("SAIL")
        .hasMessageContaining(vehicle.actuators().get(0));
  }

  @Test
  void truth_standsOnASlope_liesAsTheSlopeAndFeelsGravityOnly() {
    GroundVehicle vehicle =
        new DifferentialVehicle(
            DifferentialParameters.miniMolle(), new GroundStart(0.0, 0.0, Math.toRadians(90.0)));
    vehicle.enter(LAWN.with(Terrain.slope(0.02, 0.0))); // up to the north: to its left
    vehicle.command("LEFT MOTOR", 0.0);
    vehicle.command("RIGHT MOTOR", 0.0);
    vehicle.step(3.0);
    VehicleTruth truth = vehicle.truth();

    assertThat(truth.attitude().theta()).isCloseTo(0.0, within(1e-3));
    assertThat(truth.attitude().phi()).isCloseTo(0.02, within(1e-3)); // left side up
    Point felt = truth.specificForce();
    assertThat(felt.z()).isCloseTo(-Gravity.STANDARD_MPS2 * Math.cos(0.02), within(0.02));
    assertThat(felt.y()).isCloseTo(-Gravity.STANDARD_MPS2 * Math.sin(0.02), within(0.02));
  }

  @Test
  void contacts_drivesPastTwoPostsOfAGate_countsTheOneItTouchesOnce() {
    GroundVehicle vehicle = new DifferentialVehicle(DifferentialParameters.miniMolle());
    vehicle.enter(LAWN.with(List.of(post("left", -0.2), post("right", 0.4))));
    VehicleRun run = new VehicleRun(vehicle);
    full(run, 0L);
    for (long now = 0L; now < 8_000_000L; now += 50_000L) {
      run.at(now);
    }

    assertThat(run.at(8_000_000L).position().y()).isGreaterThan(6.0);
    assertThat(run.contacts()).extracting(c -> c.object().uid()).containsExactly("left");
    assertThat(run.contacts().get(0).timeS()).isBetween(1.0, 6.0);
  }

  private static ObjectDescription post(String uid, double east) {
    return new Cylinder()
        .radius(0.05)
        .height(2.0)
        .uid(uid)
        .referenceFrame(ReferenceFrame.LOCAL_ENU)
        .x(east)
        .y(4.0);
  }

  @Test
  void at_afterTheEndOfACommand_coastsFromThatTimeOn() {
    VehicleRun expiring =
        new VehicleRun(new DifferentialVehicle(DifferentialParameters.miniMolle()));
    VehicleRun told = new VehicleRun(new DifferentialVehicle(DifferentialParameters.miniMolle()));
    for (String motor : List.of("LEFT MOTOR", "RIGHT MOTOR")) {
      expiring.command(0L, motor, 1.0, 500_000L);
      told.command(0L, motor, 1.0);
    }
    for (String motor : List.of("LEFT MOTOR", "RIGHT MOTOR")) {
      told.command(500_000L, motor, Double.NaN);
    }

    assertThat(expiring.at(2_000_000L)).isEqualTo(told.at(2_000_000L));
  }

  @Test
  void command_withoutEnd_replacesOneWithAnEnd() {
    VehicleRun run = new VehicleRun(new DifferentialVehicle(DifferentialParameters.miniMolle()));
    for (String motor : List.of("LEFT MOTOR", "RIGHT MOTOR")) {
      run.command(0L, motor, 1.0, 500_000L);
      run.command(100_000L, motor, 1.0);
    }

    assertThat(run.at(3_000_000L).speedMps()).isGreaterThan(1.5);
  }
}
