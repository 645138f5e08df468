package org.u2sa.trials.run;

import java.nio.file.Path;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.mission.Mission;
import org.u2sa.mission.MissionManager;

/**
 * Loads a mission as the vehicle's Mission Manager does, for scoring and display: values omitted in
 * the file come from the vehicle's configuration.
 */
final class VehicleMission {
  /** The variable of a planner that circles around stations. */
  private record Circling(
      @Variable(unit = "m", min = 0, ifAbsent = 0)
          @Description("Holding-circle radius; 0: hold in place.")
          double loiterRadius) {}

  private VehicleMission() {}

  /** Radius of the circle around a station that gives none [m]; 0 if the vehicle stays there. */
  static double loiterRadiusM(SystemFile system, LaunchOptions options) {
    return system.services().stream()
        .map(options::configuration)
        .mapToDouble(each -> each.settings(Circling.class).get().loiterRadius())
        .max()
        .orElse(0.0);
  }

  /**
   * Reads a mission.
   *
   * @param options options of the run, whose overrides apply as for the Mission Manager
   * @throws BadInputException if the mission or the configuration is invalid, or the system lists
   *     no {@link MissionManager}
   */
  static Mission load(SystemFile system, LaunchOptions options, Path file) {
    SystemFile.Entry manager =
        system.services().stream()
            .filter(entry -> entry.className().equals(MissionManager.class.getName()))
            .findFirst()
            .orElseThrow(
                () ->
                    new BadInputException(
                        system.file()
                            + ": lists no service "
                            + MissionManager.class.getName()
                            + "; expected one, whose configuration supplies what "
                            + file
                            + " leaves open"));
    XmlConfiguration configuration = options.configuration(manager);
    return Mission.load(
        file,
        MessageTypes.discovered(),
        configuration.settings(MissionManager.Defaults.class).get().defaultThreshold());
  }
}
