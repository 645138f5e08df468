package org.u2sa.scenarios.suas;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicReference;
import org.u2sa.device.RadarSensor;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.frame.Point;
import org.u2sa.mission.Mission;
import org.u2sa.report.ReportFile;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.Surroundings;
import org.u2sa.trials.run.Demo;
import org.u2sa.trials.run.DemoFrame;
import org.u2sa.trials.run.RunPlans;
import org.u2sa.trials.run.SimulatedWorld;
import org.u2sa.trials.run.VehicleFileChanges;
import org.u2sa.trials.run.VehicleTrial;
import org.u2sa.vision.survey.CameraGimbal;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code u2sa demo suas}: a mission of the competition (thesis 4.4). */
@Command(
    name = "suas",
    description = {
      "Fly a SUAS mission: waypoints in order, a search area with targets, among cylinders and",
      "other aircraft, within a boundary.",
      "",
      "Field, wind and all noise depend on the seed. A judge with ground truth scores by the "
          + "competition's formulas."
    })
final class SuasDemo implements Callable<Integer>, Demo {
  @Mixin private DemoFrame frame;

  @Mixin private VehicleFileChanges changes;

  @Option(
      names = "--wind-speed",
      paramLabel = "MPS",
      description = "Steady wind, with the matching gusts; default: 5 m/s.")
  private double windMps = 5.0;

  @Option(
      names = "--train-targets",
      paramLabel = "FILE",
      description = "Train a new model of shapes and letters on painted images, then exit.")
  private Path model;

  @Option(
      names = "--laps",
      paramLabel = "N",
      description = "The mission of 2025: the waypoints N times, without a search area.")
  private int laps = 1;

  @Option(
      names = "--station-fails",
      paramLabel = "FROM[-TO]",
      description = "Time span during which the ground station is down [s].")
  private String down = "";

  @Option(
      names = "--takeover",
      paramLabel = "FROM-TO",
      description =
          "Time span during which a pilot takes over by radio [s]; then the mission continues.")
  private String takeover = "";

  @Option(
      names = "--camera-fails",
      paramLabel = "S",
      description = "The camera fails at this time [s].")
  private double cameraFailsS = Double.POSITIVE_INFINITY;

  @Option(
      names = "--told-qnh",
      paramLabel = "HPA",
      description =
          "Air pressure that the ground station sends instead of the true one; 0: no pressure.")
  private double toldHpa = Double.NaN;

  @Option(names = "--no-transponders", description = "Other aircraft have no transponder.")
  private boolean isSilent;

  @Option(
      names = "--radar",
      description = "The aircraft has a radar in addition to its transponder receiver.")
  private boolean hasRadar;

  @Option(
      names = "--hills",
      paramLabel = "M",
      description = "Height of hills at the search area; the aircraft has a map of them.")
  private double hillsM;

  @Option(
      names = "--mosaic",
      paramLabel = "M",
      description =
          "Make a mosaic of the search area on the ground, with pixels of this size [m], mosaic.png.")
  private double mosaicM;

  @Option(
      names = "--gimbal",
      paramLabel = "DEG",
      description = "Mount the camera on a gimbal that compensates up to this much roll and pitch.")
  private double gimbalDeg;

  private SuasField field; // of the newest run

  @Override
  public Integer call() throws InterruptedException, IOException {
    if (model != null) {
      String text = TargetLessons.model();
      ReportFile.writeText(model, out -> out.write(text));
      return 0;
    }
    return frame.run(this);
  }

  @Override
  public Profile profile() {
    return new Profile("suas", "suas", "plane.xml", Domain.SMALL_AIRCRAFT, 60.0, 5.0);
  }

  @Override
  public String systemFile() {
    return "plane/system-competition.xml";
  }

  @Override
  public double limitS(RunPlan plan) {
    return SuasJudge.RUN_S;
  }

  @Override
  public OptionalDouble captureRadiusM() {
    return OptionalDouble.of(15.24); // 50 ft
  }

  /** {@inheritDoc} Only for the waypoints, whose names are numbers. */
  @Override
  public RunPlan plan(Mission mission) {
    return RunPlans.placed(profile().domain(), mission, start(mission), SuasField.plane())
        .keeping(each -> Character.isDigit(each.name().charAt(0)));
  }

  @Override
  public Surroundings surroundings() {
    if (field == null) {
      return Surroundings.none();
    }
    Surroundings drawn = SimulatedWorld.surroundings(field.world(true), SuasJudge.RUN_S);
    return new Surroundings(drawn.objects(), 0.0, field.areas(), drawn.shapes());
  }

  private SuasStation.Script script(SuasField drawn) {
    double[] times = times("--station-fails", down);
    return new SuasStation.Script(
        Double.isNaN(toldHpa) ? drawn.qnhPa() : 100.0 * toldHpa,
        frame.isOwnMission() && laps == 1 ? Optional.of(SuasMission.area(drawn)) : Optional.empty(),
        SuasMission.DROP,
        times[0],
        times[1]);
  }

  /** Start and end of a span; infinite if absent. */
  private static double[] times(String option, String span) {
    double[] times = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
    String[] texts = span.isEmpty() ? new String[0] : span.split("-", 2);
    for (int i = 0; i < texts.length; i++) {
      try {
        times[i] = Double.parseDouble(texts[i]);
      } catch (NumberFormatException e) {
        throw new BadInputException(
            option + " " + span + ": \"" + texts[i] + "\": expected a span such as 300-320", e);
      }
    }
    return times;
  }

  private Optional<CameraGimbal> gimbal() {
    return gimbalDeg > 0.0
        ? Optional.of(new CameraGimbal(Math.toRadians(gimbalDeg)))
        : Optional.empty();
  }

  @Override
  public Trial trial(Mission given, Path directory, long seed) {
    SuasField level = SuasFieldGenerator.field(seed, windMps);
    SuasField all = hillsM > 0.0 ? level.on(SuasHills.of(level, hillsM)) : level;
    SuasField drawn = laps > 1 ? all.inLaps(laps) : all;
    field = drawn;
    Mission mission =
        frame.isOwnMission() ? SuasMission.write(drawn, directory.resolve("mission.xml")) : given;
    Path world = SuasMission.world(drawn, directory.resolve("world.xml"));
    Path fence = SuasMission.fence(drawn, directory.resolve("fence.xml"));
    Point start = drawn.start();
    VehicleTrial placed =
        VehicleTrial.of(
            changes.load(
                system().resolveSibling("vehicle.xml"),
                Map.of("barometer/qnh", String.valueOf(drawn.qnhPa()))),
            drawn.world(!isSilent),
            start,
            drawn.runwayRad(),
            seed);
    Optional<FieldMosaic> mosaic =
        mosaicM > 0.0 && !drawn.searchArea().isEmpty()
            ? Optional.of(new FieldMosaic(drawn, mosaicM, directory.resolve("mosaic.png")))
            : Optional.empty();
    SeenCells cells = new SeenCells(drawn, SurveyPictures.USUAL);
    SurveyPictures camera =
        new SurveyPictures(
            SurveyPictures.USUAL,
            placed.run(),
            gimbal(),
            new FieldPainter(
                drawn.targets(), SurveyPictures.USUAL, seed, mosaic.map(FieldMosaic::ground)),
            cells::see);
    double[] byHand = times("--takeover", takeover);
    SuasPilot pilot = new SuasPilot(drawn, placed.run(), byHand[0], byHand[1]);
    AtomicReference<SuasStation> station = new AtomicReference<>();
    SuasJudge.Aboard aboard =
        new SuasJudge.Aboard(
            () -> placed.devices().switchPercent("RELEASE") > 50.0,
            () -> station.get().isUp(),
            () -> station.get().changes(),
            () -> mosaic.map(FieldMosaic::figures).orElse(Map.of()));
    return placed.trial(
        mission,
        placed.name(),
        clock -> new SuasJudge(drawn, cells, aboard, directory),
        launch -> {
          launch.devices(
              new SuasDevices(placed.devices(), camera, placed.run(), cameraFailsS, pilot));
          launch.beside(
              XmlConfiguration.inMemory("SuasStation", Map.of()),
              context -> {
                station.set(new SuasStation(context, script(drawn)));
                return station.get();
              });
          if (hasRadar) {
            launch.beside(
                XmlConfiguration.load(system().resolveSibling("RadarSensor.xml")),
                RadarSensor::new);
          }
          if (hillsM > 0.0) {
            Path map = SuasHills.write(drawn, directory.resolve("heights.asc")).toAbsolutePath();
            launch.override("PathPlanner", "TERRAIN", map.toString());
            launch.override("SurveyCamera", "TERRAIN", map.toString());
          }
          gimbal()
              .ifPresent(each -> launch.override("SurveyCamera", "GIMBAL LIMIT", each.limitRad()));
          mosaic.ifPresent(each -> each.start(launch));
          launch.override("WorldModeler", "WORLD", world.toAbsolutePath().toString());
          launch.override("SafetyManager", "FENCE", fence.toAbsolutePath().toString());
        });
  }
}
