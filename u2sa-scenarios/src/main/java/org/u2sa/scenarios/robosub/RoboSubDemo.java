package org.u2sa.scenarios.robosub;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Buoy;
import org.u2sa.messages.marine.Colour;
import org.u2sa.mission.Mission;
import org.u2sa.report.ReportFile;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.Surroundings;
import org.u2sa.scenarios.run.Demo;
import org.u2sa.scenarios.run.DemoFrame;
import org.u2sa.scenarios.run.VehicleFileChanges;
import org.u2sa.scenarios.run.VehicleTrial;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code u2sa demo robosub}: tasks under water, without GPS (thesis 4.3). */
@Command(
    name = "robosub",
    description = {
      "Dive through a RoboSub layout: gate, two buoys in order, homing on a pinger, surfacing inside the ring above it.",
      "",
      "Layout, current and all noise follow from the seed. A judge with ground truth scores."
    })
final class RoboSubDemo implements Callable<Integer>, Demo {
  @Mixin private DemoFrame frame;

  @Mixin private VehicleFileChanges changes;

  @Option(
      names = "--without-estimator",
      description = "Run without a State Estimator: all goals relative to what is seen and heard.")
  private boolean isWithoutEstimator;

  private SubCourse course; // of the newest run

  @Override
  public Integer call() throws InterruptedException, IOException {
    return frame.run(this);
  }

  @Override
  public Profile profile() {
    return new Profile("robosub", "robosub", "course.xml", Domain.WATER, 60.0, 0.1);
  }

  @Override
  public String systemFile() {
    return isWithoutEstimator ? "system-without-estimator.xml" : "system.xml";
  }

  @Override
  public double limitS(RunPlan plan) {
    return SubJudge.RUN_S;
  }

  /** {@inheritDoc} Without the buoys, which are there to be touched; the judge looks at them. */
  @Override
  public Surroundings surroundings() {
    return course == null
        ? Surroundings.none()
        : new Surroundings(
            course.objects().stream()
                .filter(object -> !(object instanceof Buoy))
                .collect(Collectors.toList()),
            0.0);
  }

  @Override
  public Trial trial(Mission given, Path directory, long seed) {
    course = SubCourse.of(seed);
    SubCourse dived = course;
    SubPinger sound = SubPinger.of(seed, dived);
    Mission mission = frame.isOwnMission() ? write(dived, directory.resolve("mission.xml")) : given;
    VehicleTrial placed =
        VehicleTrial.of(
            changes.load(system().resolveSibling("vehicle.xml"), sound.changes()),
            dived.world().with(sound.objects()),
            Point.of(0.0, 0.0, -1.0),
            0.0,
            seed);
    return placed.trial(
        mission,
        placed.name(),
        clock -> new SubJudge(dived, placed.run(), directory),
        launch -> {});
  }

  private static Mission write(SubCourse course, Path file) {
    String side = SubCourse.type(course.isLeft() ? Colour.RED : Colour.GREEN, "pole");
    String first = SubCourse.type(course.colours().get(0), "buoy");
    String second = SubCourse.type(course.colours().get(1), "buoy");
    String text =
        String.format(
            Locale.ROOT,
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>%n<mission>%n"
                + "  <home><x>%.9f</x><y>%.9f</y><z>0</z><psi>0</psi></home>%n"
                + "  <passGate><name>gate</name><objectTypes>%s, white pole, %s</objectTypes></passGate>%n"
                + "  <bumpBuoy><name>first buoy</name><objectTypes>%s, %s</objectTypes></bumpBuoy>%n"
                + "  <bumpBuoy><name>second buoy</name><objectTypes>%s, yellow hoop</objectTypes></bumpBuoy>%n"
                + "  <homeOnPinger><name>pinger</name><objectTypes>pinger, yellow hoop</objectTypes></homeOnPinger>%n"
                + "  <surfaceInRing><name>ring</name><objectTypes>yellow hoop</objectTypes></surfaceInRing>%n"
                + "</mission>%n",
            SubCourse.ORIGIN.longitudeDeg(),
            SubCourse.ORIGIN.latitudeDeg(),
            side,
            first,
            first,
            second,
            second);
    ReportFile.writeText(file, out -> out.write(text));
    return Mission.load(file);
  }
}
