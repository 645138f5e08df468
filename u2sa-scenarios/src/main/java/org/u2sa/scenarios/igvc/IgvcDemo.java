package org.u2sa.scenarios.igvc;

import java.io.IOException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.Callable;
import org.u2sa.device.LidarSensor;
import org.u2sa.drivers.ioio.IoioService;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.Domain;
import org.u2sa.scenarios.run.BoardServer;
import org.u2sa.scenarios.run.Demo;
import org.u2sa.scenarios.run.DemoFrame;
import org.u2sa.scenarios.run.Simulation;
import org.u2sa.scenarios.run.TruthObserver;
import org.u2sa.vision.camera.CourseCamera;
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
      "Drive a course of the Intelligent Ground Vehicle Competition by lidar, camera and GPS.",
      "",
      "The course, its light and all noise follow from the seed, unless --course names one. A judge"
          + " who knows the truth counts line crossings, touches, speed and rest by the"
          + " competition's rules; his log is judge.log."
    })
final class IgvcDemo implements Callable<Integer>, Demo {
  private static final String SIMULATOR = "differential vehicle behind an IOIO, lidar, camera, GPS";

  private static final double MAX_MINUTES = 60.0;

  /** Course origin: Rochester, Michigan, where the competition is held. */
  private static final Geodetic ORIGIN = new Geodetic(-83.2190, 42.6780, 290.0);

  @Mixin private DemoFrame frame;

  @Option(
      names = "--course",
      paramLabel = "FILE",
      description = "World XML file of a course, as each run writes one (course.xml).")
  private Path courseFile; // null: generated from the seed

  @Option(
      names = "--ramps",
      paramLabel = "WHICH",
      description =
          "Which seeds' courses have a ramp, if there is room: ${COMPLETION-CANDIDATES} (default:"
              + " ${DEFAULT-VALUE}).",
      defaultValue = "SOME")
  private Ramps ramps;

  @Option(
      names = "--camera-dies",
      paramLabel = "S",
      description = "Disconnect the camera that many seconds after the start.")
  private double cameraDiesS = Double.POSITIVE_INFINITY;

  @Option(
      names = "--lidar-dies",
      paramLabel = "S",
      description = "Disconnect the laser that many seconds after the start.")
  private double lidarDiesS = Double.POSITIVE_INFINITY;

  @Option(
      names = "--width",
      paramLabel = "M",
      description =
          "Width of the vehicle, for courses that are made for others; planner and control are told"
              + " (default: 0.92).")
  private void width(double metres) {
    outline =
        VehicleOutline.USUAL.wide(
            within("--width", metres, VehicleOutline.NARROWEST_M, VehicleOutline.WIDEST_M, "m"));
  }

  @Option(
      names = "--minutes",
      paramLabel = "N",
      description =
          "Minutes after which the judge ends the run, for courses longer than the rules' (default:"
              + " 6).")
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
          "Adverse conditions, at places and times that follow from the seed: ${COMPLETION-CANDIDATES};"
              + " several with commas between.")
  private Set<Hardness> hardness = EnumSet.noneOf(Hardness.class);

  @Option(
      names = "--snapshot-every",
      paramLabel = "S",
      description =
          "Seconds from one picture of what the vehicle sees and knows to the next, in snapshots;"
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
    IgvcWorld world =
        new IgvcWorld(course, outline, ORIGIN, seed, cameraDiesS, lidarDiesS, hardness);
    RunFilm film = new RunFilm(course, outline, ORIGIN, directory);
    RunSnapshots snapshots = new RunSnapshots(course, outline, directory, snapshotEveryS);
    Judge judge = new Judge(course, outline.frontM(), outline.rearM(), outline.widthM(), runS);
    return new Trial(
        mission,
        TruthObserver.of(
            world::truth,
            world.world().plane(),
            new CourseScorer(judge, film, snapshots, directory, world::time)),
        launch -> {
          launch
              .override("SafetyManager", "ARM AT START", true) // the demo acts as operator
              .override("WorldModeler", "WORLD", known.toAbsolutePath().toString())
              .making(LidarSensor.class, context -> new LidarSensor(context, world.laser()))
              .making(
                  CourseCamera.class,
                  context ->
                      new CourseCamera(
                          context,
                          snapshots.watch(
                              new WatchedCamera(world.camera()), context.configuration())));
          outline.tell(launch);
          launch.devices(world.devices());
        },
        launch -> {
          launch.making(IoioService.class, context -> new IoioService(context, world.connection()));
          return new Simulation.Within(SIMULATOR, "vehicle");
        },
        launch -> {
          BoardServer server = new BoardServer(world.board(), SIMULATOR);
          launch.override("IoioService", "CONNECTION", server.address());
          return server;
        });
  }
}
