package org.u2sa.scenarios.igvc;

import java.io.IOException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.Callable;
import org.u2sa.device.port.Camera;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.Domain;
import org.u2sa.sim.camera.ColourLens;
import org.u2sa.sim.camera.Light;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.sim.device.SimulatedColourCamera;
import org.u2sa.sim.device.SimulatedLaser;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.trials.run.Demo;
import org.u2sa.trials.run.DemoFrame;
import org.u2sa.trials.run.VehicleTrial;
import org.u2sa.trials.run.WorldGaps;
import org.u2sa.vision.camera.CourseCamera;
import org.u2sa.world.xml.WorldFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code u2sa demo igvc}: a course of the competition, driven by lidar, camera and GPS. */
@Command(
    name = "igvc",
    description = {
      "Drive an Intelligent Ground Vehicle Competition course with lidar, camera and GPS.",
      "",
      "The course (unless --course gives one), its light and all noise depend on the seed. A "
          + "simulated judge with ground truth counts line crossings, contacts, speed and stops by "
          + "the competition's rules; its log is judge.log."
    })
final class IgvcDemo implements Callable<Integer>, Demo {
  private static final String SIMULATOR = "differential vehicle behind an IOIO, lidar, camera, GPS";

  private static final double MAX_MINUTES = 60.0;
  private static final double CAMERA_HZ = 5.0;

  /** Course origin: Rochester, Michigan, where the competition is held. */
  private static final Geodetic ORIGIN = new Geodetic(-83.2190, 42.6780, 290.0);

  @Mixin private DemoFrame frame;

  @Option(
      names = "--course",
      paramLabel = "FILE",
      description = "World XML file of a course, such as the course.xml of an earlier run.")
  private Path courseFile; // null: generated from the seed

  @Option(
      names = "--ramps",
      paramLabel = "WHICH",
      description =
          "Seeds for which the course has a ramp, if there is room: ${COMPLETION-CANDIDATES} "
              + "(default:"
              + " ${DEFAULT-VALUE}).",
      defaultValue = "SOME")
  private Ramps ramps;

  @Option(
      names = "--camera-dies",
      paramLabel = "S",
      description = "Disconnect the camera this many seconds after the start.")
  private double cameraDiesS = Double.POSITIVE_INFINITY;

  @Option(
      names = "--lidar-dies",
      paramLabel = "S",
      description = "Disconnect the lidar this many seconds after the start.")
  private double lidarDiesS = Double.POSITIVE_INFINITY;

  @Option(
      names = "--width",
      paramLabel = "M",
      description =
          "Width of the vehicle [m], for courses built for other vehicles; also set in planner "
              + "and control (default: 0.92).")
  private void width(double metres) {
    outline =
        VehicleOutline.USUAL.wide(
            within("--width", metres, VehicleOutline.NARROWEST_M, VehicleOutline.WIDEST_M, "m"));
  }

  @Option(
      names = "--minutes",
      paramLabel = "N",
      description =
          "Minutes after which the judge ends the run, for courses longer than in the rules "
              + "(default: 6).")
  private void minutes(double minutes) {
    runS = 60.0 * within("--minutes", minutes, 1.0, MAX_MINUTES, "min");
  }

  @Spec private CommandSpec command;
  private VehicleOutline outline = VehicleOutline.USUAL;
  private double runS = Judge.RUN_S;

  @Option(
      names = "--hard",
      paramLabel = "WHAT",
      split = ",",
      description =
          "Adverse conditions, at places and times drawn from the seed: ${COMPLETION-CANDIDATES};"
              + " several separated by commas.")
  private Set<Hardness> hardness = EnumSet.noneOf(Hardness.class);

  @Option(
      names = "--snapshot-every",
      paramLabel = "S",
      description =
          "Interval between pictures of the vehicle's perception and map, in the folder "
              + "snapshots [s];"
              + " 0: none (default: ${DEFAULT-VALUE}).",
      defaultValue = "30")
  private double snapshotEveryS;

  private double within(String option, double value, double least, double most, String unit) {
    if (!(value >= least && value <= most)) {
      throw new ParameterException(
          command.commandLine(),
          String.format(
              Locale.ROOT, "%s %s: expected %.1f…%.1f %s", option, value, least, most, unit));
    }
    return value;
  }

  @Override
  public Integer call() throws InterruptedException, IOException {
    if (courseFile != null) {
      WorldGaps.tell(WorldFile.load(courseFile), frame.terminal().out()::println);
    }
    return frame.run(this);
  }

  @Override
  public Profile profile() {
    return new Profile("igvc", "igvc", "course.xml", Domain.GROUND, 60.0, 0.05);
  }

  @Override
  public OptionalDouble captureRadiusM() {
    return OptionalDouble.of(Judge.WAYPOINT_M);
  }

  @Override
  public Trial trial(Mission given, Path directory, long seed) {
    Course course =
        courseFile == null ? CourseGenerator.course(seed, ramps) : CourseFile.read(courseFile);
    CourseFile.write(course, directory.resolve("course.xml"));
    Mission mission =
        frame.isOwnMission()
            ? CourseMission.write(course, ORIGIN, directory.resolve("mission.xml"))
            : given;
    Path known = CourseMission.writeKnown(course, ORIGIN, directory.resolve("known.xml"));
    VehicleTrial placed = placed(course, seed);
    RunFilm film = new RunFilm(course, outline, ORIGIN, directory);
    RunSnapshots snapshots = new RunSnapshots(course, outline, directory, snapshotEveryS);
    Judge judge = new Judge(course, outline.frontM(), outline.rearM(), outline.widthM(), runS);
    return placed.trial(
        mission,
        SIMULATOR,
        clock -> new CourseScorer(judge, film, snapshots, directory),
        launch -> {
          launch
              .override("WorldModeler", "WORLD", known.toAbsolutePath().toString())
              .making(
                  CourseCamera.class,
                  context ->
                      new CourseCamera(
                          context,
                          snapshots.watch(
                              new WatchedCamera(camera(course, placed, seed)),
                              context.configuration())));
          outline.tell(launch);
        });
  }

  private VehicleTrial placed(Course course, long seed) {
    NoiseStreams streams = new NoiseStreams(seed);
    SimulatedLaser.Faults faults = Hardness.laser(hardness);
    Map<String, String> changes = new LinkedHashMap<>();
    changes.put("differential/track", "" + outline.trackM());
    changes.put("body/outline/width", "" + outline.widthM());
    changes.put("laser/noEcho", "" + faults.dropOut());
    changes.put("laser/mixed", "" + faults.mixed());
    if (lidarDiesS < Double.POSITIVE_INFINITY) {
      changes.put("laser/failsAt", "" + lidarDiesS);
    }
    Course.Start start = course.start();
    VehicleTrial placed =
        VehicleTrial.behindBoard(
            VehicleFile.load(system().resolveSibling("vehicle.xml"), changes),
            course.world(ORIGIN),
            Point.of(start.eastM(), start.northM(), 0.0),
            start.headingRad(),
            Hardness.hazards(hardness, course, streams),
            seed);
    placed.devices().noise("LidarSensor", streams);
    return placed;
  }

  /** A camera with the seed's lighting. */
  private Camera camera(Course course, VehicleTrial placed, long seed) {
    NoiseStreams streams = new NoiseStreams(seed);
    Light light = Light.random(streams.of("light"));
    SimulatedColourCamera camera =
        new SimulatedColourCamera(
            ColourLens.mast().rate(CAMERA_HZ),
            new Scenery(course.objects(), light, seed),
            streams,
            placed::truth);
    camera.failAt(cameraDiesS, () -> placed.truth().timeS());
    return camera;
  }
}
