package org.u2sa.scenarios.cessna;

import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.mission.Mission;
import org.u2sa.flightgear.link.EmbeddedStart;
import org.u2sa.scenarios.report.Domain;
import org.u2sa.scenarios.report.RunPlan;
import org.u2sa.scenarios.report.StartPlace;
import org.u2sa.scenarios.run.HomeFolder;
import org.u2sa.scenarios.run.Pace;
import org.u2sa.scenarios.run.RunPlans;

/** Where the Cessna's files lie. */
final class CessnaFiles {
  /** A crawl of 25 m/s over ground to every waypoint, and ten minutes to get ready. */
  static final Pace PACE = new Pace(600.0, 25.0);

  private CessnaFiles() {}

  /** A mission as reports and screens see it, from where the aircraft stands on the runway. */
  static RunPlan plan(Mission mission) {
    Optional<StartPlace> home =
        Optional.of(EmbeddedStart.of(mission))
            .map(
                start ->
                    new StartPlace(
                        start.longitudeDeg(),
                        start.latitudeDeg(),
                        start.elevationM(),
                        start.headingRad(),
                        OptionalDouble.empty()));
    return RunPlans.of(Domain.AIR, mission, home);
  }

  /** The folder that holds {@code config} and {@code missions}. */
  static Path root() {
    return HomeFolder.holding("config/cessna");
  }

  /**
   * Has the services fly a mission.
   *
   * @param asConfigured whether it is the one for which fence and landing are configured: another
   *     one is flown without them, as it may be elsewhere on the earth
   */
  static void fly(LaunchOptions options, Mission mission, boolean asConfigured) {
    options
        .override("MissionManager", "MISSION", absolute(mission.origin()))
        .override("Simulator", "MISSION", absolute(mission.origin()));
    if (!asConfigured) {
      options.override("MissionManager", "LAND MISSION", "").override("SafetyManager", "FENCE", "");
    }
  }

  /** A file as the user named it, so that it is found from any directory. */
  private static String absolute(String file) {
    return Path.of(file).toAbsolutePath().toString();
  }
}
