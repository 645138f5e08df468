package org.u2sa.trials.run;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.u2sa.cli.record.RecordOptions;
import org.u2sa.cli.record.RunFacts;
import org.u2sa.cli.record.RunRecording;
import org.u2sa.cli.run.MavlinkLinks;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.summary.RunReport;
import org.u2sa.world.xml.WorldFile;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/**
 * Options and procedure common to all demos: reads and checks the files, and executes the runs.
 * Used as {@code @Mixin DemoFrame frame} in a command that is a {@link Demo}.
 */
public final class DemoFrame {
  @Mixin private DemoOptions options;
  @Mixin private BrokerPort broker;
  @Mixin private MavlinkLinks mavlink;
  @Mixin private RunChanges changes;
  @Mixin private RunRecording recording;

  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  private double loiterM; // the planner's LOITER RADIUS

  /** Stream for human-readable messages. */
  public Terminal terminal() {
    return options.terminal();
  }

  /** Seed of the first run. */
  public long seed() {
    return options.seed();
  }

  public boolean isRealTime() {
    return options.realtime();
  }

  /** Output folder of a command that starts several runs of a demo, as given by {@code --out}. */
  public Path directory(String demo) {
    return options.outDirectory(demo, new SystemClock().micros());
  }

  /** Whether the mission is the demo's default. */
  public boolean isOwnMission() {
    return options.mission().isEmpty();
  }

  /** Runs a demo with the requested number of runs and time mode, and returns the exit code. */
  public Integer run(Demo demo) throws InterruptedException, IOException {
    return run(demo, options.realtime(), OptionalDouble.empty());
  }

  /**
   * Runs a demo in real time.
   *
   * @param patience timeout without readings of the vehicle [s]; empty for the default
   */
  public Integer runInRealTime(Demo demo, OptionalDouble patience)
      throws InterruptedException, IOException {
    return run(demo, true, patience);
  }

  private Integer run(Demo demo, boolean realTime, OptionalDouble patience)
      throws InterruptedException, IOException {
    String name = demo.profile().name();
    SystemFile system = SystemFile.read(demo.system());
    changes.check(system);
    recording.check();
    LaunchOptions changed = new LaunchOptions();
    changes.applyTo(changed);
    Path file = options.mission().orElseGet(() -> demo.ownMission(system, changed));
    Mission mission = VehicleMission.load(system, changed, file);
    loiterM = VehicleMission.loiterRadiusM(system, changed);
    demo.world()
        .map(WorldFile::load)
        .ifPresent(world -> WorldGaps.tell(world, terminal().out()::println));
    demo.check(plan(demo, mission)); // report errors before anything is created
    return new RunLoop(options, command.commandLine().getOut())
        .run(
            demo.profile().directory(),
            (directory, seed, interruption) -> {
              Demo.Trial trial = demo.trial(mission, directory, seed);
              RunPlan plan = plan(demo, trial.mission());
              DemoRun run =
                  new DemoRun(
                      name,
                      system,
                      plan,
                      trial.mission().goals().stream()
                          .map(GoalInformation::uid)
                          .collect(Collectors.toUnmodifiableSet()),
                      demo.limitS(plan),
                      trial.observer(),
                      directory,
                      terminal(),
                      interruption,
                      changes.swaps(),
                      mavlink);
              LaunchOptions launch = launch(demo, system, trial).changesTo(changesOf(directory));
              record(launch, system, trial.mission(), demo.world(), run);
              return run(run, launch, trial, seed, realTime, patience);
            });
  }

  /**
   * Creates a folder for files that change during a demo, because the demo's own files are shared.
   */
  private static Path changesOf(Path run) {
    Path folder = run.resolve("changed-config");
    for (int k = 2; Files.exists(folder); k++) {
      folder = run.resolve("changed-config-" + k);
    }
    return folder;
  }

  private void record(
      LaunchOptions launch, SystemFile system, Mission pursued, Optional<Path> world, DemoRun run) {
    if (recording.isWanted()) {
      RecordOptions.deleteEarlier(run.directory());
    }
    RunFacts facts =
        new RunFacts()
            .say("demo", run.demo())
            .mission(Path.of(pursued.origin()))
            .system(system)
            .logs(run.directory().resolve("logs"));
    world.ifPresent(facts::world);
    recording.addTo(launch, "../", changes.addTo(facts));
  }

  private static RunReport run(
      DemoRun run,
      LaunchOptions launch,
      Demo.Trial trial,
      long seed,
      boolean realTime,
      OptionalDouble patience)
      throws InterruptedException {
    return realTime
        ? run.inRealTime(launch, seed, trial.realTime().apply(launch), patience)
        : run.inLockstep(launch, seed, trial.lockstep().apply(launch));
  }

  /** The plan of a mission, for reports and screens. */
  public RunPlan plan(Demo demo, Mission mission) {
    RunPlan plan =
        RunPlans.circled(demo.plan(mission), mission, loiterM).among(demo.surroundings());
    OptionalDouble ruled = demo.captureRadiusM();
    return ruled.isPresent() ? plan.reachedWithin(waypoint -> ruled.getAsDouble()) : plan;
  }

  private LaunchOptions launch(Demo demo, SystemFile system, Demo.Trial trial) {
    LaunchOptions launch =
        new LaunchOptions()
            .console(line -> terminal().out().println(line))
            .override("MissionManager", "MISSION", absolute(trial.mission()));
    if (!isOwnMission()
        && !demo.isConfiguredForMission()) { // it may be far from the configured position
      launch.override("MissionManager", "LAND MISSION", "").override("SafetyManager", "FENCE", "");
    }
    trial.settings().accept(launch);
    broker.configure(system, launch, terminal());
    changes.applyTo(launch); // last: the user's values take precedence
    return launch;
  }

  /** Resolves the mission file independently of the current directory. */
  public static String absolute(Mission mission) {
    return Path.of(mission.origin()).toAbsolutePath().toString();
  }
}
