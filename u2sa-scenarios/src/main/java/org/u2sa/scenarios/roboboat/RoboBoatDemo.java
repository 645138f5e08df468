package org.u2sa.scenarios.roboboat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.LongConsumer;
import org.u2sa.device.payload.SwitchOutput;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
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
import org.u2sa.service.DeviceSource;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code u2sa demo roboboat}: a course of the competition (thesis 4.2). */
@Command(
    name = "roboboat",
    description = {
      "Sail a RoboBoat course: speed gates, a channel of buoys, optional tasks, and back.",
      "",
      "Course, wind, current, waves and all noise follow from the seed. A judge with ground truth "
          + "scores gates, tasks and contacts by the rules."
    })
final class RoboBoatDemo implements Callable<Integer>, Demo {
  @Mixin private DemoFrame frame;

  @Mixin private VehicleFileChanges changes;

  @Option(
      names = "--tasks-only",
      description = "Start before the last gate of the channel, and do the optional tasks only.")
  private boolean tasksOnly;

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
    BoatCourse drawn = BoatCourseGenerator.course(seed);
    BoatCourse sailed = tasksOnly ? drawn.tasksOnly() : drawn;
    course = sailed;
    Mission mission =
        frame.isOwnMission() ? BoatMission.write(sailed, directory.resolve("mission.xml")) : given;
    VehicleTrial placed =
        VehicleTrial.of(
            changes.load(system().resolveSibling("vehicle.xml")),
            sailed.world(),
            Point.of(sailed.start().y(), sailed.start().x(), 0.0),
            sailed.headingRad(),
            seed);
    AtomicReference<BoatJudge> judge = new AtomicReference<>();
    return placed.trial(
        mission,
        placed.name(),
        clock -> {
          judge.set(new BoatJudge(sailed, placed.run(), clock, directory));
          return judge.get();
        },
        launch -> launch.devices(new DartGunSource(placed.devices(), micros -> fire(judge, micros))));
  }

  /** Before the judge looks on, nothing counts. */
  private static void fire(AtomicReference<BoatJudge> judge, long micros) {
    BoatJudge present = judge.get();
    if (present != null) {
      present.fired(micros);
    }
  }

  /** The vehicle's devices, and the gun. */
  private record DartGunSource(DeviceSource vehicle, LongConsumer fired) implements DeviceSource {
    @Override
    public <D> Optional<D> device(
        Class<D> port, String service, XmlConfiguration variables, Clock clock) {
      return port == SwitchOutput.class
          ? Optional.of(port.cast(new SimulatedDartGun(fired)))
          : vehicle.device(port, service, variables, clock);
    }
  }
}
