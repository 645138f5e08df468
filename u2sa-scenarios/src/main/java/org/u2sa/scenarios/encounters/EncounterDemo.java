package org.u2sa.scenarios.encounters;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.u2sa.cli.Main;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Box;
import org.u2sa.mission.Mission;
import org.u2sa.report.ReportFile;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.Surroundings;
import org.u2sa.scenarios.encounters.EncounterCase.Vessel;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.sim.world.ScriptedMover;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.World;
import org.u2sa.trials.run.Demo;
import org.u2sa.trials.run.DemoFrame;
import org.u2sa.trials.run.HomeFolder;
import org.u2sa.trials.run.SimulatedWorld;
import org.u2sa.trials.run.VehicleTrial;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code u2sa demo encounters}: a boat among other vessels, judged by the COLREGs. */
@Command(
    name = "encounters",
    description = {
      "Steer a small boat through published encounters with other vessels, by the COLREGs.",
      "",
      "Cases are the 55 base cases of ship-traffic-generator (dnv-01 to dnv-55) and Imazu's 22 "
          + "(imazu-01 to imazu-22), scaled to the boat. Other vessels never change course. A judge "
          + "with ground truth checks rule, distance, and early and clear action. Several cases run "
          + "one after another and end with a table."
    })
final class EncounterDemo implements Callable<Integer>, Demo {
  /** Delay until the boat gets under way [s], when the case begins. */
  static final double START_S = 3.5;

  private static final String VEHICLE = "config/vehicles/otter.xml";
  private static final double RUN_ON_S = 60.0; // after the last closest point of approach
  private static final double THRESHOLD_M = 5.0;
  private static final double FAR_S = 900.0;
  private static final double FASTEST_CURRENT_MPS = 0.3;
  private static final double FASTEST_WIND_MPS = 6.0;
  private static final double RANGE_SIGMA_M = 1.5;
  private static final double ANGLE_SIGMA_DEG = 0.5;

  @Mixin private DemoFrame frame;
  @Spec private CommandSpec command;

  @Option(
      names = "--case",
      paramLabel = "CASE",
      split = ",",
      defaultValue = "all",
      description =
          "Cases, or prefixes of their names, separated by commas: all, dnv, imazu-1, dnv-07 "
              + "(default: ${DEFAULT-VALUE}).")
  private List<String> names;

  @Option(
      names = "--vary",
      description =
          "Vary each case by the seed: speeds by up to 20 %%, courses by up to 10 degrees, a "
              + "current of up to 0.3 m/s, a wind of up to 6 m/s with gusts, and up to twice the "
              + "radar's noise.")
  private boolean vary;

  private EncounterCase encounter; // if there is only one

  @Override
  public Integer call() throws InterruptedException, IOException {
    List<EncounterCase> cases =
        EncounterCase.all().stream().filter(this::isChosen).collect(Collectors.toList());
    if (cases.isEmpty()) {
      throw new ParameterException(
          command.commandLine(),
          "--case " + String.join(",", names) + ": no such case; expected all, dnv-01 … imazu-22");
    }
    if (cases.size() > 1) {
      return runAll(cases);
    }
    EncounterCase base = cases.get(0);
    encounter = vary ? base.varied(frame.seed()) : base;
    return frame.run(this);
  }

  private boolean isChosen(EncounterCase each) {
    return names.stream().anyMatch(name -> name.equals("all") || each.name().startsWith(name));
  }

  private Integer runAll(List<EncounterCase> cases) throws IOException {
    PrintWriter out = command.commandLine().getOut();
    Path folder = frame.directory("encounters");
    out.println(EncounterScore.header());
    int clean = 0;
    for (EncounterCase each : cases) {
      Path directory = folder.resolve(each.name());
      List<String> arguments =
          new ArrayList<>(List.of("demo", "encounters", "--case", each.name(), "--port", "0"));
      arguments.addAll(List.of("--seed", "" + frame.seed(), "--summary-only"));
      arguments.addAll(List.of("--out", directory.toString()));
      if (vary) {
        arguments.add("--vary");
      }
      StringWriter said = new StringWriter();
      int code =
          Main.run(new PrintWriter(said), new PrintWriter(said), arguments.toArray(String[]::new));
      Path score = directory.resolve(EncounterScorer.FILE);
      if (Files.exists(score)) {
        Files.readAllLines(score).forEach(out::println);
      } else {
        out.println(each.name() + ": " + said);
      }
      clean += code == ExitCode.DONE ? 1 : 0;
      out.flush();
    }
    out.printf(Locale.ROOT, "%d of %d cases without a violation%n", clean, cases.size());
    return clean == cases.size() ? ExitCode.DONE : ExitCode.FAILED;
  }

  @Override
  public Profile profile() {
    return new Profile("encounters", "encounters", "mission.xml", Domain.WATER, 60.0, 0.5);
  }

  @Override
  public OptionalDouble captureRadiusM() {
    return OptionalDouble.of(2.0 * THRESHOLD_M); // the end of the route is not part of the case
  }

  @Override
  public Surroundings surroundings() {
    return SimulatedWorld.surroundings(world(new RunPlan.Start(0.0, 0.0, 0.0, 0.0), 0L), 600.0);
  }

  @Override
  public Trial trial(Mission given, Path directory, long seed) {
    Mission mission = frame.isOwnMission() ? mission(given, directory) : given;
    VehicleFile vehicle =
        VehicleFile.load(HomeFolder.holding("config/vehicles").resolve(VEHICLE), changes(seed));
    RunPlan.Start start = start(mission);
    VehicleTrial placed =
        VehicleTrial.of(vehicle, world(start, seed), Point.ORIGIN, start.headingRad(), seed);
    return placed.trial(
        mission,
        vehicle.name(),
        clock -> new EncounterScorer(new EncounterScore(encounter), directory),
        launch -> {});
  }

  /** A straight route that ends when all vessels are past. */
  private Mission mission(Mission given, Path directory) {
    RunPlan.Start start = start(given);
    double way = EncounterCase.OWN_MPS * (encounter.lastClosestS() + RUN_ON_S);
    Geodetic home = new Geodetic(start.longitudeDeg(), start.latitudeDeg(), 0.0);
    Geodetic end = home.fromNed(Point.of(way, 0.0, 0.0));
    String text =
        String.format(
            Locale.ROOT,
            "<mission>%n  <home><x>%.7f</x><y>%.7f</y><psi>0</psi></home>%n"
                + "  <waypoint><name>north</name><x>%.7f</x><y>%.7f</y><speed>%.1f</speed>"
                + "<horizontalThreshold>%.1f</horizontalThreshold></waypoint>%n</mission>%n",
            home.longitudeDeg(),
            home.latitudeDeg(),
            end.longitudeDeg(),
            end.latitudeDeg(),
            EncounterCase.OWN_MPS,
            THRESHOLD_M);
    Path file = directory.resolve("mission.xml");
    ReportFile.writeText(file, out -> out.write(text));
    return Mission.load(file);
  }

  /** Sets the radar's noise, and the area exposed to wind, which the model of the Otter lacks. */
  private Map<String, String> changes(long seed) {
    Map<String, String> changes = new LinkedHashMap<>();
    if (vary) {
      Random random = new Random(seed);
      changes.put("radar/sigma", "" + RANGE_SIGMA_M * (1.0 + random.nextDouble()));
      changes.put("radar/angleSigma", "" + ANGLE_SIGMA_DEG * (1.0 + random.nextDouble()));
      changes.put("vessel/windage", "");
      changes.put("vessel/windage/ahead", "0.2"); // ½ ρ C A for 0.4 m² seen from ahead
      changes.put("vessel/windage/aside", "0.4"); // and 0.65 m² seen from the side
      changes.put("vessel/windage/turning", "0.1");
    }
    return changes;
  }

  private World world(RunPlan.Start start, long seed) {
    Random random = new Random(seed + 1);
    double speed = vary ? FASTEST_CURRENT_MPS * random.nextDouble() : 0.0;
    double towards = 2.0 * Math.PI * random.nextDouble();
    World still =
        VehicleTrial.at(start)
            .with(new Water(0.0, speed * Math.sin(towards), speed * Math.cos(towards)));
    double windMps = FASTEST_WIND_MPS * random.nextDouble();
    double windFrom = 2.0 * Math.PI * random.nextDouble();
    World world = vary ? still.with(Wind.gusty(windFrom, windMps, seed)) : still;
    return world.withMovers(
        encounter.vessels().stream()
            .map(vessel -> mover(vessel, world))
            .collect(Collectors.toList()));
  }

  private static ScriptedMover mover(Vessel vessel, World world) {
    Box box = new Box().length(4.0).width(1.2).height(1.5);
    box.uid(vessel.uid()).objectType("vessel").referenceFrame(ReferenceFrame.LOCAL_ENU);
    box.x(vessel.eastAtM(-START_S)).y(vessel.northAtM(-START_S)).z(0.0);
    Point end = Point.of(vessel.eastAtM(FAR_S), vessel.northAtM(FAR_S), 0.0);
    return new ScriptedMover(
        box,
        world.plane(),
        List.of(new ScriptedMover.Waypoint(end, vessel.speedMps(), 0.0)),
        ScriptedMover.End.STOP,
        0.0,
        false,
        true);
  }
}
