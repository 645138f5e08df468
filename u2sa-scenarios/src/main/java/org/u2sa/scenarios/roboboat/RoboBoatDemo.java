package org.u2sa.scenarios.roboboat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.frame.Point;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.Surroundings;
import org.u2sa.scenarios.roboboat.subvehicle.QuadrotorOnDeck;
import org.u2sa.scenarios.roboboat.subvehicle.SubVehicle;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.trials.run.Demo;
import org.u2sa.trials.run.DemoFrame;
import org.u2sa.trials.run.SimulatedWorld;
import org.u2sa.trials.run.VehicleFileChanges;
import org.u2sa.trials.run.VehicleTrial;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code u2sa demo roboboat}: a RoboBoat competition course (thesis 4.2). */
@Command(
    name = "roboboat",
    description = {
      "Sail a RoboBoat course: speed gates, a channel of buoys, optional tasks, and back.",
      "",
      "Course, wind, current, waves and all noise depend on the seed. A judge with ground truth "
          + "scores gates, tasks and contacts by the rules."
    })
final class RoboBoatDemo implements Callable<Integer>, Demo {
  @Mixin private DemoFrame frame;

  @Mixin private VehicleFileChanges changes;

  @Option(
      names = "--tasks-only",
      description = "Start before the last gate of the channel and do only the optional tasks.")
  private boolean tasksOnly;

  @Option(
      names = "--radio-fails",
      description = "Suppress the quadrotor's reports: the boat must leave the dock without it.")
  private boolean radioFails;

  @Option(
      names = "--holonomic",
      description =
          "Sail with four thrusters at 45 degrees, which also push sideways, instead of two.")
  private boolean holonomic;

  @Option(
      names = "--camera",
      description =
          "Find the buoys in rendered images, instead of a simulated detector, and sail the gates only.")
  private boolean camera;

  private BoatCourse course; // of the newest run

  @Override
  public Integer call() throws InterruptedException, IOException {
    if (camera && (holonomic || tasksOnly)) {
      throw new BadInputException(
          "--camera: sails only the gates, with two thrusters; expected without --holonomic and --tasks-only");
    }
    return frame.run(this);
  }

  @Override
  public Profile profile() {
    return new Profile("roboboat", "roboboat", "course.xml", Domain.WATER, 60.0, 0.1);
  }

  @Override
  public String systemFile() {
    return holonomic ? "system-holonomic.xml" : camera ? "system-camera.xml" : "system.xml";
  }

  @Override
  public double limitS(RunPlan plan) {
    return BoatJudge.RUN_S;
  }

  /** {@inheritDoc} Omits the sub-vehicle's destination. */
  @Override
  public RunPlan plan(Mission mission) {
    return Demo.super.plan(mission).keeping(each -> !each.name().equals(BoatMission.FETCH));
  }

  @Override
  public Surroundings surroundings() {
    return course == null
        ? Surroundings.none()
        : SimulatedWorld.surroundings(course.world(), BoatJudge.RUN_S);
  }

  @Override
  public Trial trial(Mission given, Path directory, long seed) {
    BoatCourse drawn = BoatCourseGenerator.course(seed);
    BoatCourse sailed = tasksOnly ? drawn.tasksOnly() : drawn;
    course = sailed;
    Mission mission =
        frame.isOwnMission()
            ? BoatMission.write(sailed, camera, directory.resolve("mission.xml"))
            : given;
    VehicleFile file =
        changes.load(system().resolveSibling(holonomic ? "vehicle-holonomic.xml" : "vehicle.xml"));
    SimulatedVehicle boat =
        file.make(
            sailed.world(),
            Point.of(sailed.start().y(), sailed.start().x(), 0.0),
            sailed.headingRad(),
            seed);
    VehicleTrial placed = VehicleTrial.of(file, boat, seed);
    QuadrotorOnDeck quadrotor =
        new QuadrotorOnDeck(
            system().resolveSibling("quadrotor"),
            placed.run(),
            sailed.site(TaskSite.Task.DOCK).object().center(),
            directory.resolve("logs/quadrotor"),
            seed);
    Trial trial =
        placed.trial(
            mission,
            placed.name(),
            clock ->
                new BoatJudge(
                    sailed,
                    placed.run(),
                    () -> placed.devices().switchPercent(HulaHoopState.GUN),
                    quadrotor,
                    clock,
                    directory),
            launch ->
                launch.devices(
                    placed
                        .devices()
                        .with(SubVehicle.class, clock -> () -> radio(quadrotor, clock))));
    return new Trial(
        trial.mission(),
        trial.observer(),
        trial.settings(),
        launch -> trial.lockstep().apply(launch).and(quadrotor::close),
        launch -> trial.realTime().apply(launch).and(quadrotor::close));
  }

  private Transport radio(QuadrotorOnDeck quadrotor, Clock clock) {
    return radioFails ? new LocalBus("nobody") : quadrotor.switchOn(clock);
  }
}
