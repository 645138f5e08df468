package org.u2sa.sim.file;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.SimulatedVehicle;

class AircraftFileTest {
  private static final String BODY =
      """
      <body><mass unit="kg">2</mass><inertia unit="kg m^2">0.1 0.1 0.2</inertia>
        <outline><ahead>0.3</ahead><behind>0.3</behind><width>0.6</width><bottom>-0.1</bottom><top>0.1</top></outline>
      </body>
      """;

  private static String rotor(String name, double x, double y, String turns) {
    return "<rotor name=\""
        + name
        + "\"><position>"
        + x
        + " "
        + y
        + " 0</position><turns>"
        + turns
        + "</turns><fullThrust>10</fullThrust><fullTorque>0.2</fullTorque><fullSpeed unit=\"rpm\">9000</fullSpeed><lag>0.03</lag></rotor>\n";
  }

  private static final String QUAD =
      "<multirotor>\n"
          + rotor("A", 0.2, -0.2, "anticlockwise")
          + rotor("B", 0.2, 0.2, "clockwise")
          + rotor("C", -0.2, 0.2, "anticlockwise")
          + rotor("D", -0.2, -0.2, "clockwise")
          + "<skid><position>0.1 0.1 0.1</position></skid>"
          + "<skid><position>0.1 -0.1 0.1</position></skid>"
          + "<skid><position>-0.1 0 0.1</position></skid>\n</multirotor>";

  private static final String WING =
      """
      <fixedWing>
        <catapult><speed>14</speed><angle unit="deg">15</angle><height>1.8</height></catapult>
        <area>0.2589</area><span>1.4224</span><chord>0.3302</chord><efficiency>0.9</efficiency><stallAngle>0.47</stallAngle>
        <liftForce><zero>0.09</zero><alpha>3.5</alpha><pitchRate>2.9</pitchRate><elevator>0.27</elevator></liftForce>
        <parasiticDrag>0.025</parasiticDrag>
        <pitchMoment><zero>-0.023</zero><alpha>-0.57</alpha><pitchRate>-1.4</pitchRate><elevator>-0.33</elevator></pitchMoment>
        <sideForce><beta>-0.07</beta></sideForce>
        <rollMoment><beta>-0.03</beta><rollRate>-0.32</rollRate><yawRate>0.03</yawRate><aileron>0.17</aileron></rollMoment>
        <yawMoment><beta>0.02</beta><rollRate>-0.01</rollRate><yawRate>-0.004</yawRate></yawMoment>
        <surface name="LEFT ELEVON"><travel unit="deg">30</travel><lag>0.05</lag><elevator>0.5</elevator><aileron>0.5</aileron></surface>
        <surface name="RIGHT ELEVON"><travel unit="deg">30</travel><lag>0.05</lag><elevator>0.5</elevator><aileron>-0.5</aileron></surface>
        <propeller name="THROTTLE">
          <diameter>0.23</diameter><thrust>0.11 -0.05 -0.10</thrust><torque>0.006 0.004 -0.015</torque>
          <backEmf>0.00868</backEmf><resistance>0.06</resistance><idleCurrent>0.8</idleCurrent><voltage>11.1</voltage><lag>0.1</lag>
        </propeller>
      </fixedWing>
      """;

  private static VehicleFile read(String body, String dynamics) {
    String xml = "<vehicle><name>test</name>\n" + body + dynamics + "</vehicle>";
    return VehicleFile.read(new ByteArrayInputStream(xml.getBytes(UTF_8)), "test.xml");
  }

  @Test
  void make_multirotor_standsOnItsSkidsAndHoversAtTheCommandOfTheCheck() {
    VehicleFile file = read(BODY, QUAD);
    SimulatedVehicle vehicle = file.make(file.emptyWorld(), Point.ORIGIN, 0.0, 1);

    vehicle.step(2.0);
    double stands = vehicle.truth().position().z();

    assertThat(stands)
        .isCloseTo(0.1, within(0.02)); // springs give 1 cm, and more where two legs carry less
    double hover = Math.sqrt(2.0 * 9.80665 / 40.0);
    assertThat(VehicleCheck.lines(file))
        .contains(String.format("hovers with all rotors at %.1f %%", 100.0 * hover))
        .anyMatch(line -> line.startsWith("full thrust: 2.0"));
  }

  @Test
  void energyJ_rotorsAtHalfSpeed_isTheWorkOfTheirShafts() {
    VehicleFile file = read(BODY, QUAD);
    SimulatedVehicle vehicle = file.make(file.emptyWorld(), Point.ORIGIN, 0.0, 1);
    vehicle.actuators().forEach(rotor -> vehicle.command(rotor, 0.5));

    vehicle.step(20.0);

    double fullRadPerS = 9_000.0 * Math.PI / 30.0;
    double watts = 4.0 * 0.2 * 0.25 * 0.5 * fullRadPerS;
    assertThat(vehicle.energyJ().orElseThrow()).isCloseTo(20.0 * watts, within(0.2 * watts));
  }

  @Test
  void energyJ_flyingWing_isBetweenThePropellersWorkAndTheStalledMotors() {
    VehicleFile file = read(BODY, WING);
    SimulatedVehicle vehicle = file.make(file.emptyWorld(), Point.ORIGIN, 0.0, 1);

    vehicle.step(3.0);
    double waits = vehicle.energyJ().orElseThrow();
    vehicle.command("THROTTLE", 1.0);
    vehicle.step(1.0);

    assertThat(waits).isZero();
    assertThat(vehicle.energyJ().orElseThrow()).isBetween(20.0, 11.1 * 11.1 / 0.06);
  }

  @Test
  void make_flyingWing_waitsForItsMotorAndIsThrown() {
    VehicleFile file = read(BODY, WING);
    SimulatedVehicle vehicle = file.make(file.emptyWorld(), Point.ORIGIN, 0.0, 1);

    vehicle.step(3.0);
    Point waits = vehicle.truth().position();
    vehicle.command("THROTTLE", 1.0);
    vehicle.command("LEFT ELEVON", -0.5);
    vehicle.command("RIGHT ELEVON", -0.5);
    vehicle.step(1.0);

    assertThat(waits).isEqualTo(Point.of(0.0, 0.0, 1.8));
    assertThat(vehicle.truth().speedMps()).isGreaterThan(8.0);
    assertThat(vehicle.truth().position().z()).isGreaterThan(2.5);
    assertThat(VehicleCheck.lines(file)).anyMatch(line -> line.startsWith("wing: 7.72 kg/m^2"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<turns>clockwise</turns> | <turns>left</turns> | expected one of [ANTICLOCKWISE, CLOCKWISE]",
        "<fullThrust>10</fullThrust> | <fullThrust>-1</fullThrust> | expected above 0",
        "name=\"B\" | name=\"A\" | already a rotor's",
        "<lag>0.03</lag> | <lag>0.001</lag> | expected 0.002",
        "</multirotor> | <skid><position>0 0</position></skid></multirotor> | expected three numbers"
      })
  void read_invalidMultirotor_namesWhatWasExpected(String sound, String wrong, String words) {
    String dynamics = QUAD.replaceFirst(Pattern.quote(sound), wrong);
    assertThat(dynamics).isNotEqualTo(QUAD);
    assertThatThrownBy(() -> read(BODY, dynamics))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("test.xml, line ")
        .hasMessageContaining(words);
  }

  @Test
  void read_aircraftAboutAnotherPoint_isRefused() {
    String body = BODY.replace("<outline>", "<gravityCentre>0.1 0 0</gravityCentre><outline>");

    assertThatThrownBy(() -> read(body, QUAD))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("reference point is its centre of gravity");
  }

  @Test
  void read_wingThatCannotStart_isRefused() {
    String wing = WING.replaceFirst("<catapult>.*</catapult>", "");

    assertThatThrownBy(() -> read(BODY, wing))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("<wheel> nor <catapult>; expected one");
  }
}
