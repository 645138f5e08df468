package org.u2sa.scenarios.run;

import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.Function;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.mission.Mission;
import org.u2sa.scenarios.report.Domain;
import org.u2sa.scenarios.report.RunPlan;
import org.u2sa.scenarios.report.Surroundings;

/** What one demo adds to what all demos do: its files, and what a run of it consists of. */
public interface Demo {
  /**
   * What never changes.
   *
   * @param name in reports, and of its folders in {@code config} and {@code missions}
   * @param directory where its runs go unless told otherwise: {@code out/<directory>-…}
   * @param missionFile the mission unless another is asked for
   * @param domain where it moves
   * @param readyWithinS how long the vehicle may take to get ready [s]
   * @param slowestMps mean speed along the mission's legs: slower vehicles never arrive [m/s]
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

  /** The services that run, in its folder of {@code config}. */
  default String systemFile() {
    return "system.xml";
  }

  /**
   * Where the vehicle stands at first: the mission's home.
   *
   * @throws org.u2sa.interfaces.BadInputException if it has none on the earth
   */
  default RunPlan.Start start(Mission mission) {
    return RunPlans.start(mission);
  }

  /**
   * Within how many metres of a waypoint the rules count it as reached; empty: within the mission's
   * threshold.
   */
  default OptionalDouble captureRadiusM() {
    return OptionalDouble.empty();
  }

  /** What truly stands and moves around the vehicle: for the score and the picture. */
  default Surroundings surroundings() {
    return Surroundings.none();
  }

  /** The file that says what stands and moves around the vehicle, if one was given. */
  default Optional<Path> world() {
    return Optional.empty();
  }

  /**
   * Refuses options that do not fit, before anything is made.
   *
   * @throws picocli.CommandLine.ParameterException naming the option
   */
  default void check(RunPlan plan) {}

  /**
   * The world, vehicle and score of one run.
   *
   * @param directory where the files of the run go
   */
  Trial trial(Mission mission, Path directory, long seed);

  /**
   * One run of a demo.
   *
   * @param mission that the services pursue
   * @param observer of the truth
   * @param settings what is configured for this run only
   * @param lockstep makes the simulation that runs as fast as the machine allows
   * @param realTime makes the one that runs at the speed of the world
   */
  record Trial(
      Mission mission,
      RunObserver.Maker observer,
      Consumer<LaunchOptions> settings,
      Function<LaunchOptions, Simulation> lockstep,
      Function<LaunchOptions, Simulation> realTime) {}
}
