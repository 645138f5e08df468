package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.SimulatedVehicle;

/** The shipped trainer: a vehicle file with an aircraft of JSBSim's format. */
class JsbsimVehicleTest {
  private static final Path FILE =
      Path.of("").toAbsolutePath().getParent().resolve("config/vehicles/trainer.xml");

  @Test
  void load_trainer_hasMassOfTheAircraftsFileAndItsProperties() {
    assertThat(VehicleFile.load(FILE).massKg()).isCloseTo(456.5, within(0.5));
    Map<String, String> two = Map.of("jsbsim/property/value", "176.37");
    assertThat(VehicleFile.load(FILE, two).massKg()).isCloseTo(536.5, within(0.5));
  }

  @Test
  void lines_trainer_listWhatIsIgnored() {
    assertThat(VehicleCheck.lines(VehicleFile.load(FILE)))
        .anySatisfy(
            line -> assertThat(line).startsWith("ignored: ").endsWith("line 273, <output>"));
  }

  @Test
  void make_trainer_waitsOnTheCatapultForThrottle() {
    VehicleFile file = VehicleFile.load(FILE);
    SimulatedVehicle trainer = file.make(file.emptyWorld(), Point.ORIGIN, 0.0, 1);
    trainer.step(2.0);
    assertThat(trainer.truth().velocity().distance()).isZero();
    trainer.command("THROTTLE", 0.8);
    trainer.step(10.0);
    assertThat(trainer.truth().speedMps()).isBetween(25.0, 60.0);
    assertThat(trainer.truth().position().z()).isGreaterThan(80.0);
  }
}
