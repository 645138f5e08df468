package org.u2sa.scenarios.run;

import java.util.List;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.gcs.run.Setting;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** What a user wants otherwise in a run; used as {@code @Mixin RunChanges changes}. */
final class RunChanges {
  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  @Option(
      names = "--swap",
      paramLabel = "SECONDS:SERVICE=CLASS",
      description =
          "On the way, put another class in the place of a service, for example 100:PathPlanner=org.u2sa.core.planning.VectorFieldPlanner. May be given several times.")
  private List<String> swaps = List.of();

  @Option(
      names = "--set",
      paramLabel = "SERVICE:VARIABLE=VALUE",
      description =
          "Set a configuration variable for this run, for example --set \"SafetyManager:ON FENCE=LAND\". May be given several times.")
  private List<String> settings = List.of();

  /**
   * The swaps asked for.
   *
   * @throws ParameterException if one is not of that form
   */
  public List<PlannedSwap> swaps() {
    try {
      return swaps.stream().map(PlannedSwap::parse).toList();
    } catch (IllegalArgumentException e) {
      throw new ParameterException(command.commandLine(), "--swap: " + e.getMessage());
    }
  }

  /**
   * Refuses what would have no effect in that system.
   *
   * @throws ParameterException if an option is not of its form, or names a service that the system
   *     does not have
   */
  public void check(SystemFile system) {
    try {
      Setting.parseAll(settings).forEach(setting -> setting.requireServiceOf(system));
    } catch (IllegalArgumentException e) {
      throw faulty(e);
    }
    swaps();
  }

  /**
   * Has a run take the variables asked for.
   *
   * @throws ParameterException if one is not of its form
   */
  public void applyTo(LaunchOptions options) {
    settings()
        .forEach(
            setting -> options.override(setting.service(), setting.variable(), setting.value()));
  }

  private List<Setting> settings() {
    try {
      return Setting.parseAll(settings);
    } catch (IllegalArgumentException e) {
      throw faulty(e);
    }
  }

  private ParameterException faulty(IllegalArgumentException why) {
    return new ParameterException(command.commandLine(), "--set: " + why.getMessage());
  }
}
