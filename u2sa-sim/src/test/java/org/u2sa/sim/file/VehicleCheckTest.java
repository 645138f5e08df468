package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class VehicleCheckTest {
  private static final String ELEVATOR =
      """
      <vehicle><name>Elevator</name>
        <body><mass>800</mass><inertia>500 500 400</inertia>
          <outline><ahead>0.8</ahead><behind>0.8</behind><width>1.6</width><bottom>0</bottom><top>2.3</top></outline>
        </body>
        <fixedBase><direction>0 0 -1</direction><lowest>0</lowest><highest>21</highest><force>4000</force><lag>0.1</lag>
          <drag>200</drag><friction>100</friction><brake>6000</brake><counterweight>950</counterweight></fixedBase>
        <compass preset="Sparton SP3004D"/>
      </vehicle>
      """;

  @Test
  void lines_sixWheels_tellMassSpeedAndThatItTurnsOnTheSpot() {
    assertThat(VehicleCheck.lines(Vehicles.parse(Vehicles.sixWheels())))
        .contains("Six: mass 35.00 kg")
        .contains("actuators: LEFT MOTOR, RIGHT MOTOR")
        .contains("sensors: gps, compass, imu")
        .anyMatch(line -> line.matches("ahead: 2\\.0\\d m/s, up to \\d.* m/s\\^2"))
        .anyMatch(line -> line.matches("turning right: .*, on the spot"))
        .noneMatch(line -> line.startsWith("down:") || line.startsWith("right:"));
  }

  @Test
  void lines_batteryOfAMinute_tellTheSpeedWithAFullOne() {
    String small =
        Vehicles.sixWheels()
            .replaceFirst("<capacity unit=\"Ah\">[0-9]+<", "<capacity unit=\"Ah\">0.05<");

    assertThat(number(VehicleCheck.lines(Vehicles.parse(small)), "ahead: ", 1))
        .isCloseTo(2.08, within(0.01));
  }

  @Test
  void lines_twoThrustersAsternAndOneInTheBow_useTheBowsAsideOnly() {
    List<String> lines = VehicleCheck.lines(Vehicles.parse(Vehicles.threeThrusters()));

    // 103 N = 12 u + 15 u², 80.4 N astern
    assertThat(number(lines, "ahead: ", 1)).isCloseTo(2.251, within(0.01));
    assertThat(number(lines, "astern: ", 1)).isCloseTo(1.95, within(0.01));
    // 40.2 N = 40 v + 90 v²: the bow pulls left, and those astern stop the turn
    assertThat(number(lines, "left: ", 1)).isCloseTo(0.482, within(0.01));
    assertThat(lines)
        .anyMatch(line -> line.matches("turning right: .*, on the spot"))
        .anyMatch(line -> line.startsWith("ahead and turning right: a circle of 0.97"))
        .noneMatch(line -> line.startsWith("up: "));
  }

  @Test
  void lines_fourVectoredThrusters_pushTogetherInEveryDirection() {
    List<String> lines = VehicleCheck.lines(VehicleFile.load(Vehicles.BLUEROV2));

    // 4 · 40 N cos 45° = 4.03 u + 18.18 u², 4 · 30 N astern
    assertThat(number(lines, "ahead: ", 1)).isCloseTo(2.386, within(0.02));
    assertThat(number(lines, "astern: ", 1)).isCloseTo(2.052, within(0.02));
    // 4 · 30 N cos 45° = 6.22 v + 21.66 v², as two of them push astern
    assertThat(number(lines, "right: ", 1)).isCloseTo(1.84, within(0.02));
    assertThat(number(lines, "left: ", 1)).isCloseTo(1.84, within(0.02));
    // 80 N − 2 N = 5.18 w + 36.99 w², 60 N + 2 N up
    assertThat(number(lines, "down: ", 1)).isCloseTo(1.384, within(0.02));
    assertThat(number(lines, "up: ", 1)).isCloseTo(1.226, within(0.02));
    // ahead with 20 % it is steady, with 50 % it is upside down within 60 s
    assertThat(number(lines, "ahead: .*unstable above ", 1)).isBetween(20.0, 35.0);
  }

  @Test
  void lines_torpedoWithRudder_tellTheCircleOfItsRudder() {
    List<String> lines = VehicleCheck.lines(VehicleFile.load(Vehicles.REMUS_100));

    assertThat(number(lines, "ahead: ", 1)).isCloseTo(2.55, within(0.02));
    // REMUS 100 with 15° of rudder for 60 s: 7.79 deg/s at 2.51 m/s
    assertThat(number(lines, "ahead and turning right: a circle of ", 1))
        .isCloseTo(18.5, within(0.2));
    assertThat(lines).noneMatch(line -> line.startsWith("turning "));
  }

  @Test
  void lines_rudderBehindTwoThrusters_turnsByBoth() {
    String rudder =
        "<fin name=\"RUDDER\"><position>-0.6 0 0</position><direction>0 -1 0</direction>"
            + "<area>0.004</area><liftSlope>3</liftSlope><travel unit=\"deg\">30</travel>"
            + "<density>1000</density><lag>0.3</lag></fin></vessel>";
    String steered = Vehicles.threeThrusters().replace("</vessel>", rudder);
    List<String> lines = VehicleCheck.lines(Vehicles.parse(steered));

    assertThat(number(lines, "ahead and turning right: a circle of ", 1))
        .isLessThan(0.95); // 0.98 m without rudder
  }

  @Test
  void lines_thrustersThatTurnOneWayOnly_driveAnArcWithOne() {
    String oneWay =
        Vehicles.threeThrusters()
            .replaceAll("<thruster name=\"BOW\".*", "")
            .replace(
                "<direction>1 0 0</direction>", "<direction>1 0 0</direction><reverse>0</reverse>");

    assertThat(VehicleCheck.lines(Vehicles.parse(oneWay)))
        .anyMatch(line -> line.startsWith("ahead and turning right: a circle of "))
        .noneMatch(line -> line.startsWith("astern: "));
  }

  @Test
  void lines_thrustersAsternOfACentreOfGravityAhead_pushNotAside() {
    // its reference point accelerates to the side when it turns
    String ahead =
        Vehicles.text(Vehicles.WAMV)
            .replace("<outline>", "<gravityCentre>0.4 0 0</gravityCentre><outline>");

    assertThat(VehicleCheck.lines(Vehicles.parse(ahead)))
        .anyMatch(line -> line.startsWith("turning right: "))
        .noneMatch(line -> line.startsWith("right: ") || line.startsWith("left: "));
  }

  @Test
  void lines_slightlySkewedThruster_isUsedInFull() {
    String skewed =
        Vehicles.threeThrusters()
            .replaceFirst("<direction>1 0 0</direction>", "<direction>1 0.02 0</direction>");

    assertThat(number(VehicleCheck.lines(Vehicles.parse(skewed)), "ahead: ", 1))
        .isCloseTo(2.251, within(0.03));
  }

  @Test
  void lines_elevatorAtItsLowerEnd_tellTheSpeedsBothWays() {
    List<String> lines = VehicleCheck.lines(Vehicles.parse(ELEVATOR));

    // 1750 kg: 4000 N − 100 N of friction, and 150 kg more counterweight; 21 m of way
    assertThat(number(lines, "up: ", 2)).isCloseTo((3_900.0 + 1_471.0) / 1_750.0, within(0.3));
    assertThat(number(lines, "down: ", 2)).isCloseTo((3_900.0 - 1_471.0) / 1_750.0, within(0.1));
    assertThat(number(lines, "down: ", 1)).isBetween(5.5, 7.6); // √(2 · 1.388 · 21) without drag
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
    List<String> lines = VehicleCheck.lines(VehicleFile.load(Vehicles.OTTER));

    assertThat(number(lines, "ahead: ", 1)).isBetween(3.086, 3.3);
  }

  @Test
  void lines_hullOf3TonnesWithSmallThrusters_tellsItsFinalSpeed() {
    List<String> lines = VehicleCheck.lines(Vehicles.parse(hullOf3Tonnes()));

    assertThat(number(lines, "ahead: ", 1)).isCloseTo(2.251, within(0.03));
    assertThat(lines)
        .anyMatch(line -> line.startsWith("right: "))
        .anyMatch(line -> line.startsWith("turning right: "));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "ugv/vehicle.xml",
        "igvc/vehicle.xml",
        "vrx/vehicle.xml",
        "roboboat/vehicle-holonomic.xml",
        "vehicles/wamv.xml",
        "vehicles/remus100.xml",
        "suas/plane/vehicle.xml"
      })
  void lines_shippedVehicles_areFiniteNumbers(String file) {
    assertThat(VehicleCheck.lines(VehicleFile.load(Path.of("../config", file))))
        .noneMatch(line -> line.contains("NaN") || line.contains("Infinity"))
        .noneMatch(line -> line.matches(".*\\d{7}.*"));
  }

  private static String hullOf3Tonnes() {
    return Vehicles.threeThrusters()
        .replace("<mass unit=\"kg\">30<", "<mass unit=\"kg\">3000<")
        .replace(">2 4 5</inertia>", ">200 400 500</inertia>");
  }

  /** First or, behind "up to", second number of the line that begins with a pattern. */
  private static double number(List<String> lines, String start, int group) {
    Pattern numbers = Pattern.compile(start + "\\D*([0-9.]+)(?:.*?, up to ([0-9.]+))?");
    Matcher found =
        lines.stream().map(numbers::matcher).filter(Matcher::lookingAt).findFirst().orElseThrow();
    return Double.parseDouble(found.group(group));
  }
}
