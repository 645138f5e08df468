package org.u2sa.scenarios.roboboat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.u2sa.messages.frame.Point;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.Surroundings;
import org.u2sa.scenarios.run.Demo;
import org.u2sa.scenarios.run.DemoFrame;
import org.u2sa.scenarios.run.SimulatedWorld;
import org.u2sa.scenarios.run.VehicleFileChanges;
import org.u2sa.scenarios.run.VehicleTrial;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code u2sa demo roboboat}: a course of the competition (thesis 4.2). */
@Command(
    name = "roboboat",
    description = {
      "Sail a RoboBoat course: speed gates, a channel of buoys, and back.",
      "",
      "Course, wind, current, waves and all noise follow from the seed. A judge with ground truth "
          + "counts gates and contacts by the rules."
    })
final class RoboBoatDemo implements Callable<Integer>, Demo {
  @Mixin private DemoFrame frame;

  @Mixin private VehicleFileChanges changes;

  @Option(
      names = "--holonomic",
      description =
          "Sail with four thrusters at 45 degrees, which also push sideways, instead of two.")
  private boolean holonomic;

  private BoatCourse course; // of the newest run

  @Override
  public Integer call() throws InterruptedException, IOException {
    return frame.run(this);
  }

  @Override
  public Profile profile() {
    return new Profile("roboboat", "roboboat", "course.xml", Domain.WATER, 60.0, 0.1);
  }

  @Override
  public String systemFile() {
    return holonomic ? "system-holonomic.xml" : "system.xml";
  }

  @Override
  public double limitS(RunPlan plan) {
    return BoatJudge.RUN_S;
  }

  @Override
  public Surroundings surroundings() {
    return course == null
        ? Surroundings.none()
        : SimulatedWorld.surroundings(course.world(), BoatJudge.RUN_S);
  }

  @Override
  public Trial trial(Mission given, Path directory, long seed) {
    course = BoatCourseGenerator.course(seed);
    BoatCourse sailed = course;
    Mission mission =
        frame.isOwnMission() ? BoatMission.write(sailed, directory.resolve("mission.xml")) : given;
    VehicleTrial placed =
        VehicleTrial.of(
            changes.load(
                system().resolveSibling(holonomic ? "vehicle-holonomic.xml" : "vehicle.xml")),
            sailed.world(),
            Point.ORIGIN,
            0.0,
            seed);
    return placed.trial(
        mission,
        placed.name(),
        clock -> new BoatJudge(sailed, placed.run(), directory),
        launch -> {});
  }
}
