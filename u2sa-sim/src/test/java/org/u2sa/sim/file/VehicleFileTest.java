package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.file.element.Presets;
import org.u2sa.sim.ground.DifferentialParameters;
import org.u2sa.sim.ground.DifferentialVehicle;
import org.u2sa.sim.ground.GroundStart;
import org.u2sa.sim.ground.Payload;
import org.u2sa.sim.marine.BlueRov2;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.world.World;

class VehicleFileTest {
  /** Its tyres drag sideways: by the distance of its wheels it would seem to turn faster. */
  @Test
  void wheels_skidSteered_trackIsThatByWhichItTurns() {
    assertThat(Vehicles.parse(Vehicles.sixWheels()).model().wheels().orElseThrow().trackM())
        .isBetween(0.7, 1.0);
  }

  @Test
  void load_miniMolle_hasTheParametersOfTheThesisVehicle() {
    VehicleFile file = VehicleFile.load(Vehicles.MINI_MOLLE);

    assertThat(((DifferentialModel) file.model()).parameters().withPayload(Payload.none()))
        .isEqualTo(DifferentialParameters.miniMolle());
  }

  @Test
  void make_miniMolle_drivesAsTheThesisVehicle() {
    SimulatedVehicle made =
        VehicleFile.load(Vehicles.MINI_MOLLE)
            .make(VehicleFile.load(Vehicles.MINI_MOLLE).emptyWorld(), Point.ORIGIN, 0.3, 5);
    double mismatch = new GroundParts.Mismatch(Double.NaN, 0.05).of(5);
    SimulatedVehicle expected =
        new DifferentialVehicle(
            DifferentialParameters.miniMolle().withMismatch(mismatch),
            new GroundStart(0.0, 0.0, 0.3));
    for (SimulatedVehicle each : new SimulatedVehicle[] {made, expected}) {
      each.command("LEFT MOTOR", 0.8);
      each.command("RIGHT MOTOR", 0.3);
      each.step(5.0);
    }

    assertThat(made.truth()).isEqualTo(expected.truth());
  }

  @Test
  void make_blueRov2_divesAsTheVehicleInCode() {
    VehicleFile file = VehicleFile.load(Vehicles.BLUEROV2);
    World world = file.emptyWorld();
    Point start = Point.of(0.0, 0.0, -10.0);
    SimulatedVehicle made = file.make(world, start, 1.0, 1);
    SimulatedVehicle expected = BlueRov2.at(world, start, 1.0);
    for (SimulatedVehicle each : new SimulatedVehicle[] {made, expected}) {
      each.command("THRUSTER 1", 0.5);
      each.command("THRUSTER 4", -0.7);
      each.command("THRUSTER 5", 0.4);
      each.step(20.0);
    }

    assertThat(made.truth().position().distanceTo(expected.truth().position())).isLessThan(1e-9);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          <mass unit="kg">35</mass>|<mass unit="kg">-3</mass>|vehicle.xml, line 4, <mass>: -3.0 kg: expected above 0 and at most 1.0E9 kg
          <mass unit="kg">35</mass>|<mass unit="lb">35 </mass>x|text
          <mass unit="kg">35</mass>|<mass unit="m">35</mass>|vehicle.xml, line 4, <mass>: unit "m" measures length, expected mass: kg, lb
          <mass unit="kg">35</mass>|<mass unit="kg">heavy</mass>|vehicle.xml, line 4, <mass>: "heavy" is not a number of kg
          <mass unit="kg">35</mass>|<mas unit="kg">35</mas>|vehicle.xml, line 3, <body>: lacks <mass>; expected a value in kg
          <mass unit="kg">35</mass>|<mass unit="kg">35</mass><wight>3</wight>|vehicle.xml, line 4, <wight>: unknown element in <body>; expected mass, inertia, gravityCentre, inertiaAbout, outline
          0.8 1.6 2.2|0.8 1.6|vehicle.xml, line 5, <inertia>: "0.8 1.6": expected three numbers of kg m^2
          0.8 1.6 2.2|0.8 0.1 2.2|vehicle.xml, line 5, <inertia>: (0.8, 0.1, 2.2) kg m^2: no body has these moments; expected none above the sum of the other two
          0.02 0 -0.18|0.02 0 0.18|vehicle.xml, line 6, <gravityCentre>: the third number is 0.18 m: expected -2.0…0 m; down is positive
          <motor preset="AndyMark PG27"/>|<motor preset="AndyMark PG72"/>|vehicle.xml, line 20, <motor>: preset "AndyMark PG72": expected one of AndyMark PG27, Pololu 37D 30:1
          <axles unit="m">0.32 0 -0.32</axles>|<axles unit="m">0.32</axles>|vehicle.xml, line 15, <skidSteer>: axles [0.32]: expected at least two different positions
          0.02 0 -0.18|0.5 0 -0.18|vehicle.xml, line 15, <skidSteer>: axle -0.32 m: its wheels would carry -
          <ahead unit="m">0.5</ahead>|<ahead unit="m">-0.5</ahead>|vehicle.xml, line 7, <outline>: footprint
          <gps preset="survey"/>|<gps preset="survey"/><gps preset="phone"/>|is the second one without a service; expected service="NAME"
          <gps preset="survey"/>|<gps preset="survey"><sigma>-1</sigma></gps>|line 24, <sigma>: -1.0 m: expected 0.0…100.0 m
          <gps preset="survey"/>|<gps/>|line 24, <gps>: lacks <rate>; expected a value in Hz
          <gps preset="survey"/>|<gsp preset="survey"/>|line 24, <gsp>: unknown element in <vehicle>; expected name, body, differential, skidSteer, ackermann, vessel
          <skidSteer>|<skidSteer preset="six">|line 15, <skidSteer>: unknown attribute "preset"
          <name>Six</name>||line 1, <vehicle>: lacks <name>
          <capacity unit="Ah">20</capacity>|<capacity unit="Ah">1e400</capacity>|line 22, <capacity>: "1e400" is too large
          """)
  void read_wrongField_namesFileLineFieldValueAndExpectation(
      String right, String wrong, String message) {
    String text = Vehicles.sixWheels();
    assertThat(text).contains(right);

    assertThatThrownBy(() -> Vehicles.parse(text.replace(right, wrong == null ? "" : wrong)))
        .isInstanceOf(BadInputException.class)
        .hasMessageStartingWith("vehicle.xml")
        .hasMessageContaining(message);
  }

  @Test
  void read_twoDynamics_areRefused() {
    String text = Vehicles.sixWheels().replace("</skidSteer>", "</skidSteer><vessel></vessel>");

    assertThatThrownBy(() -> Vehicles.parse(text))
        .hasMessageContaining("has 2 elements of dynamics; expected exactly one of");
  }

  @Test
  void read_twoThrustersOfOneName_areRefused() {
    String text = Vehicles.threeThrusters().replace("\"STARBOARD\"", "\"PORT\"");

    assertThatThrownBy(() -> Vehicles.parse(text))
        .hasMessageContaining("line 17, <thruster>: name \"PORT\" is already an actuator's");
  }

  @Test
  void read_forcesTooStrongForTheMass_areRefusedByWhatTheyDo() {
    String text =
        Vehicles.threeThrusters()
            .replace("<mass unit=\"kg\">30", "<mass unit=\"kg\">1e-6")
            .replace("<addedMass unit=\"kg\">3 30 30", "<addedMass unit=\"kg\">0 0 0");

    assertThatThrownBy(() -> Vehicles.parse(text))
        .hasMessageContaining("vehicle.xml, line 1, <vehicle>:")
        .isInstanceOf(BadInputException.class);
  }

  @Test
  void presets_all_haveANameAndASource() {
    assertThat(Presets.all())
        .isNotEmpty()
        .allSatisfy(
            each -> {
              assertThat(each.attribute("name")).isNotEmpty();
              assertThat(each.attribute("source")).isNotEmpty();
            });
  }
}
