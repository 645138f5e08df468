package org.u2sa.scenarios.ugv;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.device.LidarSensor;
import org.u2sa.drivers.ioio.IoioService;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.Surroundings;
import org.u2sa.scenarios.run.BoardServer;
import org.u2sa.scenarios.run.Demo;
import org.u2sa.scenarios.run.DemoFrame;
import org.u2sa.scenarios.run.Laps;
import org.u2sa.scenarios.run.Simulation;
import org.u2sa.scenarios.run.TruthObserver;
import org.u2sa.sim.ground.Hazards;
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
      "Drive a ground vehicle round a loop of waypoints, through its IOIO board.",
      "",
      "Starts the Communication Manager, the services of config/ugv/system.xml, a simulated IOIO board with GPS, compass and "
          + "motors at its pins, an IMU and wheel encoders, and shows what happens. All noise follows from the seed.",
      "",
      "Other MQTT clients can listen meanwhile, for example:",
      "  mosquitto_sub -t 'u2sa/ugv/#' -F '%%t %%l bytes'"
    })
final class UgvDemo implements Callable<Integer>, Demo {
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
    /** GPS and compass at the board. */
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
          "What measures where the vehicle is: one of ${COMPLETION-CANDIDATES}. Default: ${DEFAULT-VALUE}.")
  private SensorSet sensors = SensorSet.ALL;

  @Option(
      names = "--world",
      paramLabel = "FILE",
      description = {
        "World XML file with what stands around, such as missions/ugv/yard.xml. Adds a laser that sees it, and a World Modeler "
            + "(config/ugv/system-world.xml)."
      })
  private Path worldFile; // null for an empty lawn

  @Option(
      names = "--known-start",
      description = {
        "Tell the State Estimator that the vehicle starts at the mission's home, to 0.1 m. Without that, only the receiver tells where it is."
      })
  private boolean isStartKnown;

  private Integer laps; // null if not given

  @Option(
      names = "--loops",
      paramLabel = "N",
      description = "Number of laps round the waypoints. Default: 4; 1 with --mission.")
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
        "--control proportional: is for two driven wheels; expected pursuit with --vehicle ackermann");
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
    around.conditions(vehicle, plan);
  }

  @Override
  public Trial trial(Mission mission, Path directory, long seed) {
    int wanted = laps != null ? laps : frame.isOwnMission() ? LAPS : 1;
    Mission driven =
        Laps.write(mission, wanted, leastThresholdM(), directory.resolve("mission.xml"));
    DriveConditions conditions = around.conditions(vehicle, frame.plan(this, mission));
    UgvWorld world =
        new UgvWorld(
            start(driven), vehicle, receiver, seed, Hazards.none(), conditions, obstacles());
    String simulator = simulator(world.name(), conditions);
    return new Trial(
        driven,
        TruthObserver.of(world::truth, world.world().plane(), new UnarmedMotion(world)),
        launch -> {
          configure(launch, start(driven));
          launch.devices(world.devices(seed));
        },
        launch -> {
          launch.making(IoioService.class, context -> new IoioService(context, world.connection()));
          mountLaser(launch, world, seed);
          return new Simulation.Within(simulator, "vehicle");
        },
        launch -> {
          BoardServer server = new BoardServer(world.board(), simulator);
          launch.override("IoioService", "CONNECTION", server.address());
          mountLaser(launch, world, seed);
          return server;
        });
  }

  private void mountLaser(LaunchOptions launch, UgvWorld world, long seed) {
    if (worldFile != null) {
      launch.making(LidarSensor.class, context -> new LidarSensor(context, world.laser(seed)));
    }
  }

  /** {@inheritDoc} Contacts are counted by the simulation, which knows the vehicle's outline. */
  @Override
  public Surroundings surroundings() {
    return new Surroundings(obstacles(), 0.0);
  }

  /** The filter's positions are smooth even if the receiver's jump. */
  private double leastThresholdM() {
    boolean leaps = estimator == EstimatorKind.PASS_THROUGH || control == ControlKind.PROPORTIONAL;
    return leaps ? receiver.leastThresholdM() : 0.0;
  }

  private List<ObjectDescription> obstacles() {
    return worldFile == null ? List.of() : WorldFile.load(worldFile).objects();
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
        .override(FUSING, "POSITION CORRELATION", receiver.correlationS())
        .override("SafetyManager", "ARM AT START", true); // the demo acts as operator
  }

  private String simulator(String name, DriveConditions conditions) {
    return name
        + " behind an IOIO, "
        + receiver.words()
        + ", "
        + control.name().toLowerCase(Locale.ROOT)
        + (conditions.words().isEmpty() ? "" : ", " + conditions.words());
  }
}
