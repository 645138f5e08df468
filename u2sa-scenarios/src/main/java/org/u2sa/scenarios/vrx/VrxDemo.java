package org.u2sa.scenarios.vrx;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.Surroundings;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.trials.run.Demo;
import org.u2sa.trials.run.DemoFrame;
import org.u2sa.trials.run.VehicleTrial;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code u2sa demo vrx}: a task of Virtual RobotX in one of its worlds. */
@Command(
    name = "vrx",
    description = {
      "Do a task of Virtual RobotX in one of its worlds, with the WAM-V.",
      "",
      "The world is a file of osrf/vrx (vrx_gz/worlds), which is not shipped. Wind, waves and noise "
          + "depend on the seed. A simulated judge with ground truth scores by VRX's formulas; its "
          + "log is judge.log."
    })
final class VrxDemo implements Callable<Integer>, Demo {
  private static final double READY_S = 30.0; // time for the services to arm

  @Mixin private DemoFrame frame;
  @Spec private CommandSpec command;

  @Option(
      names = "--world",
      paramLabel = "FILE",
      required = true,
      description = "World of VRX (SDF).")
  private Path worldFile;

  @Option(
      names = "--task",
      description =
          "Expected task of the world: one of ${COMPLETION-CANDIDATES}. Default: the world's.")
  private VrxTask task; // null: any

  private VrxWorld world;

  @Override
  public Integer call() throws InterruptedException, IOException {
    world = VrxWorldReader.read(worldFile);
    if (task != null && task != world.task()) {
      throw new ParameterException(
          command.commandLine(),
          String.format(
              Locale.ROOT, "--task %s: %s is a world of %s", task, worldFile, world.task()));
    }
    return frame.run(this);
  }

  @Override
  public Profile profile() {
    return new Profile("vrx", "vrx", "berths.xml", Domain.WATER, READY_S, 1.0);
  }

  @Override
  public String systemFile() {
    return switch (world.task()) {
      case STATIONKEEPING, WAYFINDING -> "system.xml";
      case PATH -> "system-path.xml";
      case DOCK -> "system-dock.xml";
      case WILDLIFE -> "system-wildlife.xml";
    };
  }

  @Override
  public Path ownMission(SystemFile system, LaunchOptions options) {
    try {
      Path file = Files.createTempFile("u2sa-vrx", ".xml");
      file.toFile().deleteOnExit();
      VrxMission.write(world, file);
      return file;
    } catch (IOException e) {
      throw new BadInputException("mission of " + worldFile + ": " + e.getMessage(), e);
    }
  }

  @Override
  public double limitS(RunPlan plan) {
    return READY_S + world.times().readyS() + world.times().runningS();
  }

  /** {@inheritDoc} For gates, half the width of the narrowest. */
  @Override
  public OptionalDouble captureRadiusM() {
    return world.gates().stream().mapToDouble(gate -> gate.widthM() / 2.0).min();
  }

  @Override
  public Surroundings surroundings() {
    return new Surroundings(world.objectsFromStart(), 0.0);
  }

  @Override
  public Trial trial(Mission given, Path directory, long seed) {
    Mission mission =
        frame.isOwnMission() ? VrxMission.write(world, directory.resolve("mission.xml")) : given;
    VehicleFile file = VehicleFile.load(system().resolveSibling("vehicle.xml"), Map.of());
    VehicleTrial placed =
        VehicleTrial.of(
            file, world.simulated(seed), VrxWorld.START, VrxWorld.START_HEADING_RAD, seed);
    return placed.trial(
        mission,
        placed.name(),
        clock -> VrxJudge.of(world, placed.run().vehicle().footprint(), directory),
        launch -> readLights(launch, placed, seed));
  }

  /** Adds the reader of the light buoy, whose camera is simulated. */
  private void readLights(LaunchOptions launch, VehicleTrial placed, long seed) {
    if (world.task() == VrxTask.DOCK) {
      LightSight sight =
          new LightSight(world.docking(), timeS -> placed.run().at(Clock.micros(timeS)), seed);
      launch.beside(
          XmlConfiguration.inMemory("LightReader", Map.of()),
          context -> new LightReader(context, sight));
    }
  }
}
