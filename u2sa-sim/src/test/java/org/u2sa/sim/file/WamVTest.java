package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.World;

/** The WAM-V of {@code config/vehicles/wamv.xml} against what its published coefficients give. */
class WamVTest {
  private static final Percentage CLOSE = Percentage.withPercentage(2.0);

  private static VehicleTruth driven(double command, Wind wind, String... changed) {
    World sea = World.at(new Geodetic(150.68, -33.72, 0.0)).with(new Water(0.0, 0.0, 0.0));
    String text = Vehicles.text(Vehicles.WAMV);
    for (int i = 0; i < changed.length; i += 2) {
      assertThat(text).contains(changed[i]);
      text = text.replace(changed[i], changed[i + 1]);
    }
    SimulatedVehicle boat = Vehicles.parse(text).make(sea.with(wind), Point.ORIGIN, 0.0, 1);
    boat.command("LEFT THRUSTER", command);
    boat.command("RIGHT THRUSTER", command);
    for (int i = 0; i < 120; i++) {
      boat.step(1.0);
    }
    return boat.truth();
  }

  @Test
  void step_fullThrust_isThePublishedSpeed() {
    assertThat(driven(1.0, Wind.calm()).speedMps()).isCloseTo(5.278, CLOSE);
  }

  @Test
  void step_halfThrust_isThePublishedSpeed() {
    assertThat(driven(Math.sqrt(0.5), Wind.calm()).speedMps()).isCloseTo(3.642, CLOSE);
  }

  @Test
  void step_windFromAstern_driftsUntilDragIsItsForce() {
    double wind = 7.0;
    VehicleTruth truth = driven(0.0, Wind.constant(Math.PI, wind));
    double speed = truth.velocity().y();
    double relative = wind - speed;

    assertThat(speed).isPositive();
    assertThat(100.0 * speed + 150.0 * speed * speed).isCloseTo(0.5 * relative * relative, CLOSE);
    assertThat(Math.sin(truth.headingRad())).isCloseTo(0.0, within(1e-6));
  }

  @Test
  void step_windFromTheBow_inBodyAxes_turnsItsBowOutOfTheWind() {
    Wind wind = Wind.constant(Math.toRadians(10.0), 7.0); // from 10° to starboard
    VehicleTruth truth = driven(0.0, wind, "<axes>WORLD</axes>", "<axes>BODY</axes>");

    assertThat(Math.IEEEremainder(truth.headingRad(), 2.0 * Math.PI)).isNegative();
  }
}
