package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;

import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.World;

/**
 * The Otter of {@code config/vehicles/otter.xml} against PythonVehicleSimulator's (c717e073), which
 * was run with the same propeller speeds.
 */
class OtterTest {
  private static final Percentage CLOSE = Percentage.withPercentage(3.0);
  private static final double FULL_RADPS = 103.93086;

  private static VehicleTruth after(double seconds, double left, double right, double currentEast) {
    World sea = World.at(new Geodetic(9.0, 54.0, 0.0)).with(new Water(0.0, currentEast, 0.0));
    SimulatedVehicle otter = VehicleFile.load(Vehicles.OTTER).make(sea, Point.ORIGIN, 0.0, 1);
    otter.command("LEFT THRUSTER", left / FULL_RADPS);
    otter.command("RIGHT THRUSTER", right / FULL_RADPS);
    otter.step(30.0);
    for (double s = 30.0; s < seconds; s += 30.0) {
      otter.step(30.0);
    }
    return otter.truth();
  }

  private static Point body(VehicleTruth truth) {
    Point enu = truth.velocity();
    return truth.attitude().nedFromFrd().transposed().times(Point.of(enu.y(), enu.x(), -enu.z()));
  }

  @Test
  void step_60And60_isTheReferencesSpeedAndWay() {
    VehicleTruth truth = after(120.0, 60.0, 60.0, 0.0);

    assertThat(body(truth).x()).isCloseTo(1.1184, CLOSE);
    assertThat(truth.position().y()).isCloseTo(132.85, CLOSE);
  }

  @Test
  void step_100And100_isTheReferencesSpeed() {
    assertThat(body(after(120.0, 100.0, 100.0, 0.0)).x()).isCloseTo(2.9820, CLOSE);
  }

  @Test
  void step_60And30_turnsAsTheReference() {
    VehicleTruth truth = after(120.0, 60.0, 30.0, 0.0);

    assertThat(body(truth).x()).isCloseTo(0.7205, CLOSE);
    assertThat(body(truth).y()).isCloseTo(-0.0431, CLOSE);
    assertThat(Math.toDegrees(truth.rates().z())).isCloseTo(7.138, CLOSE);
  }

  @Test
  void step_inACurrentFromTheSide_driftsAsTheReference() {
    VehicleTruth truth = after(120.0, 60.0, 60.0, 0.5);

    assertThat(truth.position().y()).isCloseTo(124.66, CLOSE);
    assertThat(truth.position().x()).isCloseTo(104.74, CLOSE);
  }
}
