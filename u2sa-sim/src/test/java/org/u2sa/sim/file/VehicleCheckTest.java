package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class VehicleCheckTest {
  @Test
  void lines_sixWheels_tellMassSpeedAndThatItTurnsOnTheSpot() {
    assertThat(VehicleCheck.lines(Vehicles.parse(Vehicles.sixWheels())))
        .contains("Six: mass 35.00 kg")
        .contains("actuators: LEFT MOTOR, RIGHT MOTOR")
        .contains("sensors: gps, compass, imu")
        .anyMatch(line -> line.matches("ahead: 2\\.0\\d m/s, up to \\d.* m/s\\^2"))
        .anyMatch(line -> line.matches("turning right: .* on a circle of 0\\.0\\d m radius"))
        .noneMatch(line -> line.startsWith("down:"));
  }

  @Test
  void lines_threeThrusters_goSidewaysToo() {
    assertThat(VehicleCheck.lines(Vehicles.parse(Vehicles.threeThrusters())))
        .anyMatch(line -> line.startsWith("right: "))
        .anyMatch(line -> line.startsWith("ahead: 2."))
        .noneMatch(line -> line.startsWith("up: "));
  }

  @Test
  void lines_truck_tellTheCircleOfItsSteering() {
    // docs/simulator.md: 0.78 m at full throttle
    assertThat(VehicleCheck.lines(VehicleFile.load(Vehicles.TRUCK)))
        .anyMatch(line -> line.startsWith("ahead and turning right: a circle of 0.7"));
  }

  @Test
  void lines_otter_haveTheReferencesTopSpeedWithinThreePercent() {
    // 24.4 kgf over the drag at 6 knots, and what the trim adds
    String ahead =
        VehicleCheck.lines(VehicleFile.load(Vehicles.OTTER)).stream()
            .filter(line -> line.startsWith("ahead: "))
            .findFirst()
            .orElseThrow();

    assertThat(Double.parseDouble(ahead.split(" ")[1])).isBetween(3.086, 3.3);
  }

  @Test
  void lines_hullOf30TonnesWithSmallThrusters_stillTellSpeedsAndTurns() {
    String heavy =
        Vehicles.threeThrusters()
            .replace("<mass unit=\"kg\">30<", "<mass unit=\"kg\">30000<")
            .replace(">2 4 5</inertia>", ">2000 4000 500000</inertia>");

    assertThat(VehicleCheck.lines(Vehicles.parse(heavy)))
        .anyMatch(line -> line.startsWith("ahead: "))
        .anyMatch(line -> line.startsWith("right: "))
        .anyMatch(line -> line.startsWith("turning right: "));
  }
}
