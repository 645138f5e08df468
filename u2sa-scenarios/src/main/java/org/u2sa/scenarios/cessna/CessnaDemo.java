package org.u2sa.scenarios.cessna;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.flightgear.link.EmbeddedStart;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.Sphere;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.Surroundings;
import org.u2sa.sim.aircraft.RunwayStart;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.device.SimulatedTraffic;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.sim.world.LocalPlane;
import org.u2sa.trials.run.Demo;
import org.u2sa.trials.run.DemoFrame;
import org.u2sa.trials.run.HomeFolder;
import org.u2sa.trials.run.Simulation;
import org.u2sa.trials.run.VehicleTrial;
import org.u2sa.world.xml.WorldFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code u2sa demo cessna}: take-off and ten waypoints in the embedded simulator. */
@Command(
    name = "cessna",
    description = {
      "Fly a Cessna 172 over ten waypoints, take-off included.",
      "",
      "Starts the Communication Manager, the services of config/cessna/system.xml and the embedded simulator, and shows the "
          + "flight. Wind and gusts depend on the seed. Control uses the simulator's true "
          + "state or, with --estimator fusing, noisy GPS, barometer, airspeed, IMU and compass.",
      "",
      "Other MQTT clients can listen during the flight, for example:",
      "  mosquitto_sub -t 'u2sa/cessna/#' -F '%%t %%l bytes'"
    })
final class CessnaDemo implements Callable<Integer>, Demo {
  /** State Estimator. */
  enum FlightEstimator {
    /** Ground truth from the simulator. */
    PASS_THROUGH,
    /** Error-state Kalman filter fusing noisy GPS, barometer, airspeed, IMU and compass. */
    FUSING
  }

  private static final double HALF_SPAN_M = 5.5;

  @Mixin private DemoFrame frame;
  @Spec private CommandSpec command;

  @Option(
      names = "--wind",
      paramLabel = "WIND",
      description =
          "calm, or SPEED@DIRECTION in m/s and degrees true, such as 5@270 for a west wind. "
              + "Default: drawn from the seed, up to 8 m/s.")
  private String wind;

  @Option(
      names = "--shear",
      description =
          "Wind increases with height: --wind is the wind 6 m above ground; at 300 m it is 1.8 times as strong. Default: constant with height.")
  private boolean shear;

  @Option(
      names = "--estimator",
      description = "One of ${COMPLETION-CANDIDATES}. Default: pass_through; fusing with --world.")
  private FlightEstimator estimator; // null if not given

  @Option(
      names = "--world",
      paramLabel = "FILE",
      description = {
        "World XML file with the surroundings, such as missions/cessna/obstructed.xml: static "
            + "objects are known from a chart, moving ones are reported by a traffic receiver. Adds "
            + "the receiver, a World Modeler and a planner that avoids both, with noisy sensors "
            + "(config/cessna/system-world.xml)."
      })
  private Path worldFile; // null for an empty sky

  private Surroundings around; // null until read

  @Override
  public Integer call() throws InterruptedException, IOException {
    return frame.run(this);
  }

  @Override
  public Profile profile() {
    return flying("cessna");
  }

  @Override
  public String systemFile() {
    if (worldFile != null) {
      return "system-world.xml";
    }
    return estimator == FlightEstimator.FUSING ? "system-fused.xml" : "system.xml";
  }

  /** {@inheritDoc} The extent is half the wing span. */
  @Override
  public Surroundings surroundings() {
    if (around == null) {
      around =
          worldFile == null
              ? Surroundings.none()
              : new Surroundings(WorldFile.load(worldFile).objects(), HALF_SPAN_M);
    }
    return around;
  }

  /** Profile with a minimum ground speed of 25 m/s, and ten minutes to become ready. */
  static Profile flying(String directory) {
    return new Profile("cessna", directory, "mission.xml", Domain.AIR, 600.0, 25.0);
  }

  @Override
  public RunPlan.Start start(Mission mission) {
    return onRunway(mission);
  }

  /** Start position on the runway. */
  static RunPlan.Start onRunway(Mission mission) {
    RunwayStart start = EmbeddedStart.of(mission);
    return new RunPlan.Start(
        start.longitudeDeg(), start.latitudeDeg(), start.elevationM(), start.headingRad());
  }

  @Override
  public Optional<Path> world() {
    return Optional.ofNullable(worldFile);
  }

  @Override
  public void check(RunPlan plan) {
    windOf(frame.seed());
    if (frame.isRealTime() && estimator == FlightEstimator.FUSING) {
      throw new ParameterException(
          command.commandLine(),
          "--estimator: \"fusing\" needs sensors, which the simulator of --realtime lacks; expected pass_through");
    }
    if (worldFile != null && estimator == FlightEstimator.PASS_THROUGH) {
      throw new ParameterException(
          command.commandLine(), "--world: expected --estimator fusing, which is its default");
    }
  }

  @Override
  public Trial trial(Mission mission, Path directory, long seed) {
    DemoWind demoWind = windOf(seed);
    frame
        .terminal()
        .out()
        .printf(
            Locale.ROOT,
            "Seed %d, wind %.1f m/s from %.0f degrees%s%n",
            seed,
            demoWind.speedMps(),
            Math.toDegrees(demoWind.fromRad()),
            shear ? " near the ground, increasing with height" : "");
    return new Trial(
        mission,
        FlightObserver::new,
        launch -> {
          launch.override("Simulator", "MISSION", DemoFrame.absolute(mission));
          around(launch);
        },
        launch -> {
          VehicleTrial placed = placed(onRunway(mission), demoWind.wind(seed), seed);
          placed.devices().traffic(() -> traffic(placed));
          launch.override("Simulator", "LINK", "embedded").devices(placed.devices());
          return new Simulation.Within(placed.name(), "aircraft");
        },
        launch -> StandInSimulation.of(mission, demoWind.wind(seed), launch));
  }

  /** The aircraft, read from its vehicle file, on the runway. */
  static VehicleTrial placed(RunPlan.Start start, Wind wind, long seed) {
    String folder = "config/cessna";
    return VehicleTrial.of(
        VehicleFile.load(HomeFolder.holding(folder).resolve(folder).resolve("vehicle.xml")),
        VehicleTrial.at(start).with(wind),
        Point.ORIGIN,
        start.headingRad(),
        seed);
  }

  /** Moving objects around the aircraft that report their position by transponder. */
  private List<SimulatedTraffic.Other> traffic(VehicleTrial placed) {
    double timeS = placed.run().at(0L).timeS();
    LocalPlane plane = placed.world().plane();
    return surroundings().objects().stream()
        .filter(Surroundings::moves)
        .map(
            object -> {
              Point here = place(object, plane, timeS);
              Point soon = place(object, plane, timeS + 1.0);
              return new SimulatedTraffic.Other(
                  object.uid(), object.objectType(), here, soon.minus(here));
            })
        .toList();
  }

  private static Point place(ObjectDescription object, LocalPlane plane, double timeS) {
    Point centre = Surroundings.centreAfter(object, timeS);
    return plane.point(Surroundings.onEarth(object, centre, plane.origin()));
  }

  /** Configures the chart of static objects and the separation from the largest moving one. */
  private void around(LaunchOptions launch) {
    if (worldFile == null) {
      return;
    }
    launch.override("WorldModeler", "WORLD", worldFile.toAbsolutePath().toString());
    surroundings().objects().stream()
        .filter(Surroundings::moves)
        .filter(Sphere.class::isInstance)
        .mapToDouble(ball -> ((Sphere) ball).radius())
        .max()
        .ifPresent(radius -> launch.override("TrafficSensor", "SEPARATION", Math.max(1.0, radius)));
  }

  private DemoWind windOf(long seed) {
    if (wind == null) {
      return DemoWind.ofSeed(seed).withShear(shear);
    }
    try {
      return DemoWind.parse(wind).withShear(shear);
    } catch (IllegalArgumentException e) {
      throw new ParameterException(command.commandLine(), "--wind: " + e.getMessage());
    }
  }
}
