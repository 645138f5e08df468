package org.u2sa.trials.run;

import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.Function;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.mission.Mission;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.Surroundings;

/** The demo-specific parts of a demo: its files, and the components of a run. */
public interface Demo {
  /**
   * Constant properties of a demo.
   *
   * @param name name in reports, and of its folders in {@code config} and {@code missions}
   * @param directory default output directory of its runs: {@code out/<directory>-…}
   * @param missionFile the default mission
   * @param domain the vehicle's domain
   * @param readyWithinS maximum time until the vehicle is ready [s]
   * @param slowestMps minimum mean speed along the mission's legs, for the time limit [m/s]
   */
  record Profile(
      String name,
      String directory,
      String missionFile,
      Domain domain,
      double readyWithinS,
      double slowestMps) {}

  /** Its name, files and limits. */
  Profile profile();

  /** System file of the services, in its folder of {@code config}. */
  default String systemFile() {
    return "system.xml";
  }

  /** System file of the services. */
  default Path system() {
    String folder = "config/" + profile().name();
    return HomeFolder.holding(folder).resolve(folder).resolve(systemFile());
  }

  /**
   * The mission without {@code --mission}.
   *
   * @param options the run's changes of configuration
   */
  default Path ownMission(SystemFile system, LaunchOptions options) {
    return HomeFolder.holding("missions/" + profile().name())
        .resolve("missions")
        .resolve(profile().name())
        .resolve(profile().missionFile());
  }

  /** Whether the configuration's fence and landing mission also apply to a {@code --mission}. */
  default boolean isConfiguredForMission() {
    return false;
  }

  /** The plan of a mission, for reports and screens. */
  default RunPlan plan(Mission mission) {
    return RunPlans.of(profile().domain(), mission, Optional.of(start(mission)));
  }

  /** Time limit of a run [s]. */
  default double limitS(RunPlan plan) {
    return profile().readyWithinS() + plan.lengthM() / profile().slowestMps();
  }

  /**
   * Initial position of the vehicle: the mission's home.
   *
   * @throws org.u2sa.interfaces.BadInputException if the mission has no home in earth coordinates
   */
  default RunPlan.Start start(Mission mission) {
    return RunPlans.start(mission);
  }

  /**
   * Distance within which the rules count a waypoint as reached [m]; empty for the mission's
   * threshold.
   */
  default OptionalDouble captureRadiusM() {
    return OptionalDouble.empty();
  }

  /** Ground truth of the objects around the vehicle, for the score and the picture. */
  default Surroundings surroundings() {
    return Surroundings.none();
  }

  /** World file of the objects around the vehicle, if given. */
  default Optional<Path> world() {
    return Optional.empty();
  }

  /**
   * Validates the options before anything is created.
   *
   * @throws picocli.CommandLine.ParameterException naming the option
   */
  default void check(RunPlan plan) {}

  /**
   * Creates the world, vehicle and score of one run.
   *
   * @param directory output directory of the run
   */
  Trial trial(Mission mission, Path directory, long seed);

  /**
   * One run of a demo.
   *
   * @param mission the mission that the services execute
   * @param observer records ground truth
   * @param settings configuration overrides of this run
   * @param lockstep creates the simulation for lockstep, as fast as the machine allows
   * @param realTime creates the simulation for real time
   */
  record Trial(
      Mission mission,
      RunObserver.Maker observer,
      Consumer<LaunchOptions> settings,
      Function<LaunchOptions, Simulation> lockstep,
      Function<LaunchOptions, Simulation> realTime) {}
}
