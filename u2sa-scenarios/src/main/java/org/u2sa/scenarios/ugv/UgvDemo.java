package org.u2sa.scenarios.ugv;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.messages.frame.Point;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.Surroundings;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.world.World;
import org.u2sa.trials.run.Demo;
import org.u2sa.trials.run.DemoFrame;
import org.u2sa.trials.run.Laps;
import org.u2sa.trials.run.VehicleTrial;
import org.u2sa.world.xml.WorldFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code u2sa demo ugv}: the ground vehicle drives laps of a waypoint loop, through its board. */
@Command(
    name = "ugv",
    description = {
      "Drive a ground vehicle around a loop of waypoints, through its IOIO board.",
      "",
      "Starts the Communication Manager, the services of config/ugv/system.xml, a simulated IOIO board with GPS, compass and "
          + "motors at its pins, an IMU and wheel encoders, and shows the drive. All noise depends on the seed.",
      "",
      "Other MQTT clients can listen during the run, for example:",
      "  mosquitto_sub -t 'u2sa/ugv/#' -F '%%t %%l bytes'"
    })
final class UgvDemo implements Callable<Integer>, Demo {
  /** Vehicle. */
  enum VehicleKind {
    /** The thesis's Mini-Molle: two driven wheels and a castor. */
    DIFFERENTIAL("vehicle.xml"),
    /** A 1:10 truck with steered front wheels. */
    ACKERMANN("vehicle-ackermann.xml");

    private final String file;

    VehicleKind(String file) {
      this.file = file;
    }

    /** Element of its dynamics in its file. */
    String dynamics() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /** Controller. */
  enum ControlKind {
    /** Regulated pure pursuit. */
    PURSUIT,
    /** The thesis's proportional controller per wheel; differential drive only. */
    PROPORTIONAL
  }

  /** State Estimator. */
  enum EstimatorKind {
    /** Error-state Kalman filter using all sensors. */
    FUSING,
    /** Raw GPS and compass measurements. */
    PASS_THROUGH
  }

  /** Sensor set. */
  enum SensorSet {
    /** GPS and compass on the board, an IMU, and encoders on two driven wheels. */
    ALL("system.xml"),
    /** GPS and compass on the board. */
    BOARD("system-board.xml"),
    /** GPS, compass, IMU and encoders as separate services. */
    FOUR_SERVICES("system-four-sensors.xml");

    private final String file;

    SensorSet(String file) {
      this.file = file;
    }
  }

  private static final int LAPS = 4;
  private static final String FUSING = "FusingStateEstimator";
  private static final double START_SIGMA_M = 0.1;

  @Mixin private DemoFrame frame;
  @Mixin private ConditionOptions around;
  @Spec private CommandSpec command;

  @Option(
      names = "--vehicle",
      description = "One of ${COMPLETION-CANDIDATES}. Default: ${DEFAULT-VALUE}.")
  private VehicleKind vehicle = VehicleKind.DIFFERENTIAL;

  @Option(
      names = "--receiver",
      description = "Grade of the GPS: one of ${COMPLETION-CANDIDATES}. Default: ${DEFAULT-VALUE}.")
  private GpsGrade receiver = GpsGrade.SURVEY;

  @Option(
      names = "--control",
      description = "One of ${COMPLETION-CANDIDATES}. Default: ${DEFAULT-VALUE}.")
  private ControlKind control = ControlKind.PURSUIT;

  @Option(
      names = "--estimator",
      description =
          "One of ${COMPLETION-CANDIDATES}; --control proportional drives by pass_through. Default: ${DEFAULT-VALUE}.")
  private EstimatorKind estimator = EstimatorKind.FUSING;

  @Option(
      names = "--sensors",
      description =
          "Localisation sensors: one of ${COMPLETION-CANDIDATES}. Default: ${DEFAULT-VALUE}.")
  private SensorSet sensors = SensorSet.ALL;

  @Option(
      names = "--world",
      paramLabel = "FILE",
      description = {
        "World XML file with the surroundings, such as missions/ugv/yard.xml. Adds a laser that "
            + "detects it, and a World Modeler "
            + "(config/ugv/system-world.xml)."
      })
  private Path worldFile; // null for an empty lawn

  @Option(
      names = "--known-start",
      description = {
        "Let the State Estimator assume that the vehicle starts at the mission's home, to 0.1 m. "
            + "Otherwise it knows the position only from the GPS receiver."
      })
  private boolean isStartKnown;

  private Integer laps; // null if not given

  @Option(
      names = "--loops",
      paramLabel = "N",
      description = "Number of laps around the waypoints. Default: 4; 1 with --mission.")
  private void loops(int value) {
    if (value < 1) {
      throw new ParameterException(
          command.commandLine(), "--loops " + value + ": expected 1 or more");
    }
    laps = value;
  }

  @Override
  public Integer call() throws InterruptedException, IOException {
    return frame.run(this);
  }

  @Override
  public Profile profile() {
    return new Profile("ugv", "ugv", "loop.xml", Domain.GROUND, 60.0, 0.2);
  }

  @Override
  public String systemFile() {
    boolean isUsual = vehicle == VehicleKind.DIFFERENTIAL && control == ControlKind.PURSUIT;
    boolean isFused = estimator == EstimatorKind.FUSING;
    expect(
        vehicle == VehicleKind.DIFFERENTIAL || control == ControlKind.PURSUIT,
        "--control proportional: requires two driven wheels; expected pursuit with --vehicle ackermann");
    expect(
        isFused || vehicle == VehicleKind.DIFFERENTIAL,
        "--estimator pass_through: expected --vehicle differential");
    expect(
        sensors == SensorSet.ALL || isUsual && isFused,
        "--sensors: expected --vehicle differential, --control pursuit and --estimator fusing");
    expect(
        worldFile == null || control == ControlKind.PURSUIT && isFused && sensors == SensorSet.ALL,
        "--world: expected --control pursuit, --estimator fusing and --sensors all");
    if (vehicle == VehicleKind.ACKERMANN) {
      return worldFile == null ? "system-ackermann.xml" : "system-ackermann-world.xml";
    }
    if (worldFile != null) {
      return "system-world.xml";
    }
    if (control == ControlKind.PROPORTIONAL) {
      return "system-proportional.xml";
    }
    return isFused ? sensors.file : "system-pass-through.xml";
  }

  private void expect(boolean holds, String otherwise) {
    if (!holds) {
      throw new ParameterException(command.commandLine(), otherwise);
    }
  }

  @Override
  public Optional<Path> world() {
    return Optional.ofNullable(worldFile);
  }

  @Override
  public void check(RunPlan plan) {
    around.check(vehicle);
  }

  @Override
  public Trial trial(Mission mission, Path directory, long seed) {
    int wanted = laps != null ? laps : frame.isOwnMission() ? LAPS : 1;
    Mission driven =
        Laps.write(mission, wanted, leastThresholdM(), directory.resolve("mission.xml"));
    RunPlan.Start start = start(driven);
    Map<String, String> changes = around.changes(vehicle);
    changes.put("gps/@preset", receiver.preset());
    changes.put("ioio/gps/@preset", receiver.preset());
    World ground = around.ground(VehicleTrial.at(start), frame.plan(this, mission));
    VehicleTrial placed =
        VehicleTrial.behindBoard(
            VehicleFile.load(system().resolveSibling(vehicle.file), changes),
            VehicleTrial.around(ground, world(), seed),
            Point.ORIGIN,
            start.headingRad(),
            Hazards.none(),
            seed);
    placed.devices().noise("LidarSensor", new NoiseStreams(seed));
    return placed.trial(
        driven,
        simulator(placed.name()),
        clock -> new UnarmedMotion(placed),
        launch -> configure(launch, start));
  }

  /** {@inheritDoc} Contacts are counted by the simulation, which knows the vehicle's outline. */
  @Override
  public Surroundings surroundings() {
    return worldFile == null
        ? Surroundings.none()
        : new Surroundings(WorldFile.load(worldFile).objects(), 0.0);
  }

  /** The filter's positions are smooth even if the receiver's positions jump. */
  private double leastThresholdM() {
    boolean leaps = estimator == EstimatorKind.PASS_THROUGH || control == ControlKind.PROPORTIONAL;
    return leaps ? receiver.leastThresholdM() : 0.0;
  }

  private void configure(LaunchOptions launch, RunPlan.Start start) {
    if (isStartKnown) {
      launch
          .override(FUSING, "START X", start.longitudeDeg())
          .override(FUSING, "START Y", start.latitudeDeg())
          .override(FUSING, "START SIGMA", START_SIGMA_M);
    }
    if (estimator == EstimatorKind.FUSING && control != ControlKind.PROPORTIONAL) {
      launch.override("IoioService", "GPS DELAY", receiver.delayS());
    }
    launch
        .override("PassThroughStateEstimator", "STALE AFTER", receiver.fixTimeoutS())
        .override(FUSING, "POSITION CORRELATION", receiver.correlationS());
  }

  private String simulator(String name) {
    String conditions = around.words();
    return name
        + " behind an IOIO, "
        + receiver.words()
        + ", "
        + control.name().toLowerCase(Locale.ROOT)
        + (conditions.isEmpty() ? "" : ", " + conditions);
  }
}
