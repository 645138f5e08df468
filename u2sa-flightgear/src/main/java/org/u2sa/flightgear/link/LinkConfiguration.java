package org.u2sa.flightgear.link;

import org.u2sa.core.mission.Mission;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.service.ServiceContext;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.atmosphere.Wind;

/** Opens the link to the aircraft that the Simulator's variables describe. */
final class LinkConfiguration {
  static final VariableDeclaration<String> LINK =
      VariableDeclaration.text("LINK")
          .oneOf("embedded", "flightgear")
          .ifAbsent("embedded")
          .describedAs(
              "embedded: the Cessna 172 of u2sa-sim, in lockstep; flightgear: FlightGear's generic protocol over TCP.");

  static final VariableDeclaration<String> MISSION =
      VariableDeclaration.text("MISSION")
          .ifAbsent("")
          .describedAs(
              "Mission file whose home is where the embedded aircraft stands, relative to the configuration file.");

  static final VariableDeclaration<Double> WIND_SPEED =
      VariableDeclaration.number("WIND SPEED", "m/s")
          .range(Range.of(0.0, 30.0))
          .ifAbsent(0.0)
          .describedAs(
              "Wind for the embedded aircraft: at every height, or with WIND SHEAR 6 m above ground.");

  static final VariableDeclaration<Double> WIND_FROM =
      VariableDeclaration.number("WIND FROM", "rad")
          .range(Range.of(0.0, 2.0 * Math.PI))
          .ifAbsent(0.0)
          .describedAs(
              "Where the wind blows from, true, clockwise from north, for the embedded aircraft.");

  static final VariableDeclaration<Boolean> WIND_SHEAR =
      VariableDeclaration.flag("WIND SHEAR")
          .ifAbsent(false)
          .describedAs(
              "Whether the wind grows with height (MIL-F-8785C, 3.7.3.4: 1.8 times as strong at 300 m), for the embedded aircraft.");

  static final VariableDeclaration<Boolean> GUSTS =
      VariableDeclaration.flag("GUSTS")
          .ifAbsent(true)
          .describedAs(
              "Whether the wind has Dryden gusts, seeded by the run, for the embedded aircraft.");

  static final VariableDeclaration<String> HOST =
      VariableDeclaration.text("FLIGHTGEAR HOST")
          .ifAbsent("127.0.0.1")
          .describedAs("Where FlightGear runs.");

  static final VariableDeclaration<Integer> OUT_PORT =
      VariableDeclaration.integer("FLIGHTGEAR OUT PORT")
          .range(Range.of(1, 65_535))
          .ifAbsent(5501)
          .describedAs("TCP port on which this service awaits FlightGear's readings.");

  static final VariableDeclaration<Integer> IN_PORT =
      VariableDeclaration.integer("FLIGHTGEAR IN PORT")
          .range(Range.of(1, 65_535))
          .ifAbsent(5502)
          .describedAs("TCP port on which FlightGear awaits controls.");

  static final VariableDeclaration<Integer> PROPERTY_PORT =
      VariableDeclaration.integer("FLIGHTGEAR PROPERTY PORT")
          .range(Range.of(0, 65_535))
          .ifAbsent(5503)
          .describedAs(
              "TCP port of FlightGear's property server, which repairs a cut link; 0: none.");

  private final Configurator variables;
  private final ServiceContext context;

  LinkConfiguration(Configurator variables, ServiceContext context) {
    this.variables = variables;
    this.context = context;
  }

  /**
   * Opens it.
   *
   * @throws BadInputException if the Simulator is started anew, or takes the place of another, and
   *     the aircraft was embedded: then it ends with the one before, and another one would begin
   *     another flight
   */
  AircraftLink open() {
    String link = variables.getVariable(LINK);
    String mission = variables.getVariable(MISSION);
    double windSpeedMps = variables.getVariable(WIND_SPEED);
    double windFromRad = variables.getVariable(WIND_FROM);
    boolean shear = variables.getVariable(WIND_SHEAR);
    boolean gusts = variables.getVariable(GUSTS);
    String host = variables.getVariable(HOST);
    int outPort = variables.getVariable(OUT_PORT);
    int inPort = variables.getVariable(IN_PORT);
    int propertyPort = variables.getVariable(PROPERTY_PORT);
    if (link.equals("flightgear")) {
      return new FlightGearLink(host, outPort, inPort, propertyPort, context.clock());
    }
    if (context.isRestart()) {
      throw new BadInputException(
          "variable \"LINK\": \"embedded\": the aircraft has ended with the Simulator that was before; run the system anew");
    }
    if (context.isSwap()) {
      throw new BadInputException(
          "variable \"LINK\": \"embedded\": the aircraft would end with the Simulator that is to be replaced; expected \"flightgear\" for a swap in flight");
    }
    Wind steady =
        gusts
            ? Wind.gusty(windFromRad, windSpeedMps, context.seed())
            : Wind.constant(windFromRad, windSpeedMps);
    Wind wind = steady.withShear(shear);
    return new EmbeddedAircraft(
        Cessna172.onRunway(
            EmbeddedStart.of(Mission.load(context.configuration().resolve(mission))), wind, true));
  }
}
