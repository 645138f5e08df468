package org.u2sa.sim.guide;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

class CarriageTest {
  private static final double MASS_KG = 800.0;

  private static Carriage elevator(double counterweightKg) {
    return carriage(
        new Guide(
            Point.of(0.0, 0.0, -1.0),
            0.0,
            20.0,
            4_000.0,
            0.1,
            200.0,
            0.0,
            6_000.0,
            counterweightKg),
        0.0);
  }

  private static Carriage carriage(Guide guide, double headingRad) {
    return new Carriage(
        guide,
        MASS_KG,
        Footprint.rectangle(0.8, 0.8, 1.6, 0.0, 2.3),
        World.at(new Geodetic(0.0, 0.0, 0.0)),
        Point.ORIGIN,
        headingRad);
  }

  @Test
  void step_balancedElevator_reachesForceOverDrag() {
    Carriage elevator = elevator(MASS_KG);
    elevator.command(Carriage.DRIVE, 0.05);

    elevator.step(4.0);

    double time = 2.0 * MASS_KG / 200.0; // of the speed, mass over drag
    double expected = 1.0 - time / (time - 0.1) * Math.exp(-4.0 / time);
    assertThat(elevator.truth().velocity().z()).isCloseTo(expected, within(0.01));
    assertThat(elevator.energyJ().orElseThrow()).isPositive();
  }

  @Test
  void step_weightAboveTheForce_restsOnTheLowerEnd() {
    Carriage elevator = elevator(0.0);
    elevator.command(Carriage.DRIVE, 1.0);
    elevator.step(0.5);

    double expected = 4_000.0 / MASS_KG - Gravity.STANDARD_MPS2;
    assertThat(expected).isNegative();
    assertThat(elevator.truth().position().z()).as("rests on its lower end").isZero();
    assertThat(elevator.truth().velocity().z()).isZero();
  }

  @Test
  void step_noSignal_brakeHolds() {
    Carriage elevator = elevator(900.0);
    elevator.command(Carriage.DRIVE, 0.1);
    elevator.step(3.0);
    elevator.command(Carriage.DRIVE, Double.NaN);
    elevator.step(5.0);
    double held = elevator.truth().position().z();

    elevator.step(20.0);

    assertThat(held).isBetween(1.0, 19.0);
    assertThat(elevator.truth().position().z()).isCloseTo(held, within(1e-9));
  }

  @Test
  void step_upperEnd_stops() {
    Carriage elevator = elevator(MASS_KG);
    elevator.command(Carriage.DRIVE, 1.0);

    elevator.step(30.0);

    VehicleTruth truth = elevator.truth();
    assertThat(truth.position().z()).isEqualTo(20.0);
    assertThat(truth.velocity()).isEqualTo(Point.ORIGIN);
  }

  @Test
  void step_railAhead_followsTheHeading() {
    Guide rail = new Guide(Point.of(1.0, 0.0, 0.0), -5.0, 5.0, 100.0, 0.1, 50.0, 0.0, 1_000.0, 0.0);
    Carriage trolley = carriage(rail, Math.toRadians(90.0));
    trolley.command(Carriage.DRIVE, -1.0);

    trolley.step(2.0);

    assertThat(trolley.truth().position().x()).isNegative();
    assertThat(trolley.truth().position().y()).isCloseTo(0.0, within(1e-9));
    assertThat(trolley.truth().position().z()).isZero();
  }

  @Test
  void guide_startOutsideTravel_isRefused() {
    assertThatThrownBy(
            () -> new Guide(Point.of(1.0, 0.0, 0.0), 1.0, 5.0, 1.0, 0.1, 0.0, 0.0, 0.0, 0.0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("contains the start");
  }
}
