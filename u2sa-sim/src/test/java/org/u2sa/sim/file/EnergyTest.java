package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.SimulatedVehicle;

class EnergyTest {
  private static final double SECONDS = 20.0;

  private static SimulatedVehicle vehicle(String xml) {
    VehicleFile file =
        VehicleFile.read(
            new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "vehicle.xml");
    return file.make(file.emptyWorld(), Point.ORIGIN, 0.0, 1);
  }

  @Test
  void energyJ_roverThatStands_isTheIdleCurrents() {
    SimulatedVehicle rover = vehicle(Vehicles.sixWheels());

    rover.step(SECONDS);

    assertThat(rover.energyJ().orElseThrow())
        .isCloseTo(0.5 * (12.8 - 0.5 * 0.043) * SECONDS, within(0.5));
  }

  @Test
  void energyJ_roverThatDrives_isMoreThanItsMotion() {
    SimulatedVehicle rover = vehicle(Vehicles.sixWheels());
    rover.actuators().forEach(side -> rover.command(side, 1.0));

    rover.step(SECONDS);

    double speed = rover.truth().speedMps();
    assertThat(rover.energyJ().orElseThrow()).isGreaterThan(130.0 + 0.5 * 35.0 * speed * speed);
  }

  @Test
  void energyJ_thrusterAtFullCommand_isItsPower() {
    SimulatedVehicle boat = vehicle(Vehicles.threeThrusters());
    boat.command("BOW", 1.0);

    boat.step(SECONDS);

    assertThat(boat.energyJ().orElseThrow())
        .isCloseTo(390.0 * SECONDS, Percentage.withPercentage(2.0));
  }

  @Test
  void energyJ_thrusterAtQuarterThrustAstern_isAnEighthOfItsPower() {
    SimulatedVehicle boat = vehicle(Vehicles.threeThrusters());
    boat.command("BOW", -(0.0625 + 0.5 * (1.0 - 0.0625)));

    boat.step(SECONDS);

    assertThat(boat.energyJ().orElseThrow())
        .isCloseTo(390.0 / 8.0 * SECONDS, Percentage.withPercentage(2.0));
  }

  @Test
  void energyJ_thrusterWithoutPower_isUnknown() {
    SimulatedVehicle otter =
        VehicleFile.load(Vehicles.OTTER)
            .make(VehicleFile.load(Vehicles.OTTER).emptyWorld(), Point.ORIGIN, 0.0, 1);

    otter.step(SECONDS);

    assertThat(otter.energyJ()).isEmpty();
  }
}
