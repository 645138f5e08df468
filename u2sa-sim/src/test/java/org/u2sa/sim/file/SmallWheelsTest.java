package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.ground.GroundState;
import org.u2sa.sim.ground.GroundVehicle;

/** Rovers of a few hundred grams, whose wheels settle much faster than a tick of 2 ms. */
class SmallWheelsTest {
  private static final Path TINY = Path.of("src/test/resources/org/u2sa/sim/file/tiny-rover.xml");
  private static final double FREE_RADPS = 31.3; // at the full battery's voltage

  private static VehicleFile tiny(
      double massKg, double radiusM, double inertia, double relaxationM) {
    return VehicleFile.load(
        TINY,
        Map.of(
            "body/mass",
            String.valueOf(massKg),
            "body/inertia",
            String.format(
                Locale.ROOT, "%s %s %s", 0.0008 * massKg, 0.001 * massKg, 0.0016 * massKg),
            "differential/wheelRadius",
            String.valueOf(radiusM),
            "differential/motor/inertia",
            String.valueOf(inertia),
            "differential/tyre/relaxation",
            String.valueOf(relaxationM)));
  }

  private static GroundVehicle make(VehicleFile file) {
    return (GroundVehicle) file.make(file.emptyWorld(), Point.ORIGIN, 0.0, 1);
  }

  private static void command(GroundVehicle vehicle, double left, double right) {
    vehicle.command("LEFT MOTOR", left);
    vehicle.command("RIGHT MOTOR", right);
  }

  @ParameterizedTest
  @CsvSource({"0.5, 0.217", "1, 0.202", "2, 0.172", "4, 0.111"})
  void step_lightMotor_drivesAsFastAsWithAHeavierOne(double massKg, double speedMps) {
    for (double inertia : new double[] {1e-5, 1e-4}) {
      GroundVehicle rover = make(tiny(massKg, 0.021, inertia, 0.01));
      command(rover, 0.4, 0.4);
      rover.step(2.0);

      assertThat(rover.truth().velocity().y()).isCloseTo(speedMps, within(0.003));
    }
  }

  /** Nothing that is accepted spins backwards, faster than its motor, or on when it is stopped. */
  @Test
  void step_gridOfMassesRadiiAndInertias_wheelsFollowTheirMotors() {
    List<String> refused = new ArrayList<>();
    for (double massKg : new double[] {0.05, 0.5, 4.0}) {
      for (double radiusM : new double[] {0.01, 0.021, 0.1}) {
        for (double inertia : new double[] {1e-6, 1e-5, 1e-4}) {
          for (double relaxationM : new double[] {0.01, 0.05}) {
            String name = massKg + " kg, " + radiusM + " m, " + inertia + ", " + relaxationM + " m";
            VehicleFile file;
            try {
              file = tiny(massKg, radiusM, inertia, relaxationM);
            } catch (BadInputException e) {
              refused.add(name);
              continue;
            }
            drive(name, file, radiusM, 0.1);
            drive(name, file, radiusM, 1.0);
          }
        }
      }
    }

    assertThat(refused).as("of 54").hasSizeLessThanOrEqualTo(18);
  }

  private static void drive(String name, VehicleFile file, double radiusM, double command) {
    GroundVehicle rover = make(file);
    command(rover, command, command);
    for (int i = 0; i < 100; i++) {
      rover.step(0.01);
      GroundState state = rover.state();
      assertThat(state.leftWheelRadPerS()).as(name).isBetween(-0.05, command * FREE_RADPS);
      assertThat(rover.truth().velocity().y()).as(name).isGreaterThan(-0.003);
    }
    double rimMps = rover.state().leftWheelRadPerS() * radiusM;
    assertThat(rover.truth().velocity().y())
        .as(name)
        .isCloseTo(rimMps, within(0.2 * Math.abs(rimMps) + 0.003));

    command(rover, command, -command);
    rover.step(1.0);
    assertThat(rover.truth().rates().z()).as(name).isGreaterThan(-0.05);

    command(rover, 0.0, 0.0);
    rover.step(2.0);
    assertThat(rover.truth().speedMps()).as(name).isLessThan(0.01);
    assertThat(rover.truth().rates().z()).as(name).isCloseTo(0.0, within(0.05));
  }

  @Test
  void load_wheelsTooFastForAnyStep_areRefusedInWords() {
    assertThatThrownBy(() -> tiny(50.0, 0.1, 1e-6, 0.01))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("its wheels and tyres settle within")
        .hasMessageContaining("too fast for the simulator");
  }
}
