package org.u2sa.flightgear.link;

import java.util.Optional;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.mission.Mission;
import org.u2sa.service.ServiceContext;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.aircraft.RunwayStart;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.vehicle.VehicleRun;

/** Opens the link to the aircraft that the Simulator's variables describe. */
final class LinkConfiguration {
  private record Variables(
      @Variable(
              oneOf = {"embedded", "flightgear"},
              ifAbsentText = "embedded")
          @Description(
              "embedded: the Cessna 172 of u2sa-sim in lockstep (with u2sa simulate, the vehicle file's aircraft); flightgear: FlightGear's generic protocol over TCP.")
          String link,
      @Variable(ifAbsentText = "")
          @Description(
              "Mission file whose home is the embedded aircraft's starting position, relative to the configuration file.")
          String mission,
      @Variable(unit = "m/s", min = 0, max = 30, ifAbsent = 0)
          @Description(
              "Wind speed for the embedded aircraft: at every height, or with WIND SHEAR at 6 m above ground.")
          double windSpeed,
      @Variable(unit = "rad", min = 0, max = 2.0 * Math.PI, ifAbsent = 0)
          @Description(
              "True direction from which the wind blows, clockwise from north, for the embedded aircraft.")
          double windFrom,
      @Variable(ifAbsentText = "false")
          @Description(
              "Whether the wind increases with height, for the embedded aircraft (MIL-F-8785C, 3.7.3.4: 1.8 times as strong at 300 m).")
          boolean windShear,
      @Variable(ifAbsentText = "true")
          @Description(
              "Whether the wind has Dryden gusts, seeded by the run, for the embedded aircraft.")
          boolean gusts,
      @Variable(ifAbsentText = "127.0.0.1") @Description("Host on which FlightGear runs.")
          String flightgearHost,
      @Variable(min = 1, max = 65_535, ifAbsent = 5501)
          @Description("TCP port on which this service receives FlightGear's readings.")
          int flightgearOutPort,
      @Variable(min = 1, max = 65_535, ifAbsent = 5502)
          @Description("TCP port on which FlightGear receives controls.")
          int flightgearInPort,
      @Variable(min = 0, max = 65_535, ifAbsent = 5503)
          @Description(
              "TCP port of FlightGear's property server, used to restore a lost link; 0: none.")
          int flightgearPropertyPort) {}

  private final Settings<Variables> settings;
  private final ServiceContext context;

  LinkConfiguration(Configurator variables, ServiceContext context) {
    settings = variables.settings(Variables.class);
    this.context = context;
  }

  /**
   * Opens the link.
   *
   * @throws BadInputException if the Simulator of an embedded aircraft is restarted or replaced:
   *     the aircraft ends with its Simulator, and a new one would start another flight
   */
  AircraftLink open() {
    Variables now = settings.get();
    if (now.link().equals("flightgear")) {
      context.beforeDevice();
      return new FlightGearLink(
          now.flightgearHost(),
          now.flightgearOutPort(),
          now.flightgearInPort(),
          now.flightgearPropertyPort(),
          context.clock());
    }
    if (context.isRestart()) {
      throw new BadInputException(
          "variable \"LINK\": \"embedded\": the aircraft ends with its Simulator; restart the whole system");
    }
    if (context.isSwap()) {
      throw new BadInputException(
          "variable \"LINK\": \"embedded\": the aircraft would end with the replaced Simulator; expected \"flightgear\" for a swap in flight");
    }
    Optional<VehicleRun> provided =
        context
            .devices()
            .device(VehicleRun.class, "Simulator", context.configuration(), context.clock());
    if (provided.isPresent()) {
      return new EmbeddedAircraft(provided.get());
    }
    Wind steady =
        now.gusts()
            ? Wind.gusty(now.windFrom(), now.windSpeed(), context.seed())
            : Wind.constant(now.windFrom(), now.windSpeed());
    Wind wind = steady.withShear(now.windShear());
    RunwayStart start =
        EmbeddedStart.of(Mission.load(context.configuration().resolve(now.mission())));
    return new EmbeddedAircraft(new VehicleRun(Cessna172.onRunway(start, wind, true)));
  }
}
