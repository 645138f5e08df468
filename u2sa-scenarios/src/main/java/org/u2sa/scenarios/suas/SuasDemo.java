package org.u2sa.scenarios.suas;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.u2sa.messages.frame.Point;
import org.u2sa.mission.Mission;
import org.u2sa.report.ReportFile;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.Surroundings;
import org.u2sa.scenarios.run.Demo;
import org.u2sa.scenarios.run.DemoFrame;
import org.u2sa.scenarios.run.RunPlans;
import org.u2sa.scenarios.run.SimulatedWorld;
import org.u2sa.scenarios.run.VehicleFileChanges;
import org.u2sa.scenarios.run.VehicleTrial;
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
      "Field, wind and all noise follow from the seed. A judge with ground truth scores by the "
          + "competition's formulas."
    })
final class SuasDemo implements Callable<Integer>, Demo {
  @Mixin private DemoFrame frame;

  @Mixin private VehicleFileChanges changes;

  @Option(
      names = "--wind-speed",
      paramLabel = "MPS",
      description = "Steady wind, with the matching gusts; 5 m/s if absent.")
  private double windMps = 5.0;

  @Option(
      names = "--train-targets",
      paramLabel = "FILE",
      description = "Write a new model of shapes and letters from painted images, and end.")
  private Path model;

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

  /** {@inheritDoc} Only the waypoints, which have numbers for names. */
  @Override
  public RunPlan plan(Mission mission) {
    RunPlan all = RunPlans.placed(profile().domain(), mission, start(mission), SuasField.plane());
    List<RunPlan.Waypoint> numbered =
        all.waypoints().stream()
            .filter(each -> Character.isDigit(each.name().charAt(0)))
            .collect(Collectors.toList());
    return new RunPlan(all.domain(), all.home(), numbered);
  }

  @Override
  public Surroundings surroundings() {
    return field == null
        ? Surroundings.none()
        : new Surroundings(
            SimulatedWorld.surroundings(field.world(), SuasJudge.RUN_S).objects(),
            0.0,
            field.areas());
  }

  @Override
  public Trial trial(Mission given, Path directory, long seed) {
    SuasField drawn = SuasFieldGenerator.field(seed, windMps);
    field = drawn;
    Mission mission =
        frame.isOwnMission() ? SuasMission.write(drawn, directory.resolve("mission.xml")) : given;
    Path world = SuasMission.world(drawn, directory.resolve("world.xml"));
    Path fence = SuasMission.fence(drawn, directory.resolve("fence.xml"));
    Point start = drawn.start();
    VehicleTrial placed =
        VehicleTrial.of(
            changes.load(system().resolveSibling("vehicle.xml")),
            drawn.world(),
            start,
            drawn.runwayRad(),
            seed);
    SeenCells cells = new SeenCells(drawn, SurveyPictures.USUAL);
    SurveyPictures camera =
        new SurveyPictures(
            SurveyPictures.USUAL,
            placed.run(),
            new FieldPainter(drawn.targets(), SurveyPictures.USUAL, seed),
            cells::see);
    return placed.trial(
        mission,
        placed.name(),
        clock -> new SuasJudge(drawn, cells, directory),
        launch -> {
          launch.devices(new SuasDevices(placed.devices(), camera));
          launch.override("WorldModeler", "WORLD", world.toAbsolutePath().toString());
          launch.override("SafetyManager", "FENCE", fence.toAbsolutePath().toString());
        });
  }
}
