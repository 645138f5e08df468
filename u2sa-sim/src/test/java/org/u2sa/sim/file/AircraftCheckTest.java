package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.flight.Catapult;
import org.u2sa.sim.flight.UnmannedAircraft;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;

class AircraftCheckTest {
  private static final double WEIGHT_N = 2.0 * 9.80665;

  private static String rotor(String name, double x, double y, String turns, double lagS) {
    return String.format(
        Locale.ROOT,
        "<rotor name=\"%s\"><position>%s %s 0</position><turns>%s</turns>"
            + "<fullThrust>10</fullThrust><fullTorque>0.2</fullTorque>"
            + "<fullSpeed>900</fullSpeed><lag>%s</lag></rotor>",
        name,
        x,
        y,
        turns,
        lagS);
  }

  private static VehicleFile copter(String rotors) {
    return Vehicles.parse(
        "<vehicle><name>copter</name><body><mass>2</mass><inertia>0.1 0.1 0.2</inertia><outline>"
            + "<ahead>0.3</ahead><behind>0.3</behind><width>0.6</width><bottom>-0.1</bottom>"
            + "<top>0.1</top></outline></body><multirotor>"
            + rotors
            + "<skid><position>0.1 0.1 0.1</position></skid>"
            + "<skid><position>0.1 -0.1 0.1</position></skid>"
            + "<skid><position>-0.1 0 0.1</position></skid></multirotor></vehicle>");
  }

  private static VehicleFile quad(double aheadM, double behindM, double lagS) {
    return copter(
        rotor("A", aheadM, -0.2, "anticlockwise", lagS)
            + rotor("B", aheadM, 0.2, "clockwise", lagS)
            + rotor("C", -behindM, 0.2, "anticlockwise", lagS)
            + rotor("D", -behindM, -0.2, "clockwise", lagS));
  }

  private static List<Double> numbers(VehicleFile file, String start) {
    String line =
        VehicleCheck.lines(file).stream()
            .filter(each -> each.startsWith(start))
            .findFirst()
            .orElseThrow();
    return List.of(line.substring(start.length()).replaceAll("[^0-9.]+", " ").trim().split(" "))
        .stream()
        .map(Double::valueOf)
        .toList();
  }

  @ParameterizedTest
  @CsvSource({"0.2, 0.1", "0.1, 0.3"})
  void lines_rotorsAtUnequalDistances_hoverLevelAsTold(double aheadM, double behindM) {
    VehicleFile file = quad(aheadM, behindM, 0.03);
    List<Double> percents = numbers(file, "hovers with rotors at ");
    SimulatedVehicle copter = file.make(file.emptyWorld(), Point.of(0.0, 0.0, 100.0), 0.0, 1);
    boolean isFrontWeak = aheadM > behindM;
    List.of("A", "B")
        .forEach(each -> copter.command(each, percents.get(isFrontWeak ? 0 : 1) / 100));
    List.of("C", "D")
        .forEach(each -> copter.command(each, percents.get(isFrontWeak ? 1 : 0) / 100));

    copter.step(1.0);

    double fullN = 20.0 * (1.0 + Math.min(aheadM, behindM) / Math.max(aheadM, behindM));
    assertThat(numbers(file, "full thrust: ").get(0)).isCloseTo(fullN / WEIGHT_N, within(0.01));
    VehicleTruth truth = copter.truth();
    assertThat(truth.attitude().theta()).isCloseTo(0.0, within(0.05));
    assertThat(truth.acceleration().z()).isCloseTo(0.0, within(0.1));
  }

  @Test
  void lines_rotorsThatSpinUpWithinSeconds_tellTheirFullThrust() {
    VehicleFile file = quad(0.2, 0.2, 2.0);

    assertThat(numbers(file, "full thrust: ").get(0)).isCloseTo(40.0 / WEIGHT_N, within(0.01));
    assertThat(numbers(file, "hovers with all rotors at ").get(0))
        .isCloseTo(100.0 * Math.sqrt(WEIGHT_N / 40.0), within(0.1));
  }

  @Test
  void lines_threeRotors_hoverTurning() {
    VehicleFile file =
        copter(
            rotor("A", 0.1, -0.2, "clockwise", 0.03)
                + rotor("B", 0.1, 0.2, "anticlockwise", 0.03)
                + rotor("C", -0.2, 0.0, "clockwise", 0.03));

    assertThat(VehicleCheck.lines(file))
        .anyMatch(line -> line.startsWith("hovers with all rotors at 80.9 %"))
        .anyMatch(line -> line.startsWith("turns while it hovers"));
  }

  @Test
  void lines_rotorsOnOneSide_cannotHover() {
    VehicleFile file =
        copter(rotor("A", 0.2, 0.2, "clockwise", 0.03) + rotor("B", -0.2, 0.2, "clockwise", 0.03));

    assertThat(VehicleCheck.lines(file))
        .contains("cannot hover: its rotors' moments do not balance");
  }

  @Test
  void lines_aerosonde_fliesAsFastAsToldAtFullThrottle() {
    VehicleFile file = VehicleFile.load(Vehicles.AEROSONDE);
    Point start = Point.of(0.0, 0.0, 200.0);
    UnmannedAircraft plane = (UnmannedAircraft) file.make(file.emptyWorld(), start, 0.0, 1);
    double heightM = plane.truth().position().z();
    plane.launch(new Catapult(25.0, 0.05, 20.0, 1.0));
    plane.command("THROTTLE", 1.0);
    double dtS = 0.01;
    double trim = 0.0;
    for (int i = 0; i < 8_000; i++) { // holds height and wings level
      VehicleTruth truth = plane.truth();
      double wanted = 0.03 * (heightM - truth.position().z()) - 0.06 * truth.velocity().z();
      double pitch = limited(wanted) - truth.attitude().theta();
      trim += dtS * pitch;
      plane.command("ELEVATOR", limited(-3.0 * pitch + 0.3 * truth.rates().y() - 2.0 * trim));
      plane.command("AILERON", limited(-1.5 * truth.attitude().phi() - 0.2 * truth.rates().x()));
      plane.step(dtS);
    }

    assertThat(plane.truth().position().z()).isCloseTo(heightM, within(1.0));
    assertThat(numbers(file, "level flight: ").get(1))
        .isCloseTo(plane.truth().speedMps(), within(0.3));
  }

  private static double limited(double command) {
    return Math.max(-1.0, Math.min(1.0, command));
  }
}
