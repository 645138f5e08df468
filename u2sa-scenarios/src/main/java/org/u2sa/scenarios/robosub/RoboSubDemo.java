package org.u2sa.scenarios.robosub;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.u2sa.messages.frame.Point;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.Surroundings;
import org.u2sa.scenarios.robosub.course.PingerTask;
import org.u2sa.scenarios.robosub.course.SubCourse;
import org.u2sa.scenarios.robosub.course.SubJudge;
import org.u2sa.scenarios.robosub.course.SubMission;
import org.u2sa.trials.run.Demo;
import org.u2sa.trials.run.DemoFrame;
import org.u2sa.trials.run.VehicleFileChanges;
import org.u2sa.trials.run.VehicleTrial;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code u2sa demo robosub}: tasks under water, without GPS (thesis 4.3). */
@Command(
    name = "robosub",
    description = {
      "Dive through a RoboSub layout: gate, two buoys in order, homing on a pinger, surfacing inside",
      "the ring above it.",
      "",
      "Layout, current and all noise depend on the seed. A judge with ground truth scores the run."
    })
final class RoboSubDemo implements Callable<Integer>, Demo {
  private static final double AFLOAT_M = 0.12; // depth of the hull's middle at the start

  @Mixin private DemoFrame frame;

  @Mixin private VehicleFileChanges changes;

  @Option(
      names = "--without-estimator",
      description = "Run without a State Estimator: all goals are relative to detected objects.")
  private boolean isWithoutEstimator;

  private SubCourse course; // of the newest run

  @Override
  public Integer call() throws InterruptedException, IOException {
    return frame.run(this);
  }

  @Override
  public Profile profile() {
    return new Profile("robosub", "robosub", "course.xml", Domain.UNDERWATER, 60.0, 0.1);
  }

  @Override
  public String systemFile() {
    return isWithoutEstimator ? "system-without-estimator.xml" : "system.xml";
  }

  @Override
  public double limitS(RunPlan plan) {
    return SubJudge.RUN_S;
  }

  @Override
  public Surroundings surroundings() {
    return course == null ? Surroundings.none() : new Surroundings(course.objects(), 0.0);
  }

  @Override
  public Trial trial(Mission given, Path directory, long seed) {
    course = SubCourse.of(seed);
    SubCourse dived = course;
    Mission mission =
        frame.isOwnMission() ? SubMission.write(dived, directory.resolve("mission.xml")) : given;
    VehicleTrial placed =
        VehicleTrial.of(
            changes.load(system().resolveSibling("vehicle.xml"), PingerTask.changes(dived)),
            dived.world(),
            Point.of(0.0, 0.0, -AFLOAT_M),
            0.0,
            seed);
    return placed.trial(
        mission,
        placed.name(),
        clock -> new SubJudge(dived, placed.run(), placed.devices()::switchPercent, directory),
        launch -> {});
  }
}
