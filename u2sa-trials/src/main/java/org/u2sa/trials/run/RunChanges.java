package org.u2sa.trials.run;

import java.util.List;
import java.util.function.Supplier;
import org.u2sa.cli.command.Setting;
import org.u2sa.cli.record.RunFacts;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.SystemFile;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/**
 * Modifications of a run: services to swap and variables to set; used as {@code @Mixin RunChanges
 * changes}.
 */
final class RunChanges {
  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  private List<SwapOperator.PlannedSwap> swaps = List.of();
  private List<Setting> settings = List.of();

  @Option(
      names = "--swap",
      paramLabel = "SECONDS:SERVICE=CLASS",
      description =
          "Replace a service with another class during the run, for example 100:PathPlanner=org.u2sa.planning.VectorFieldPlanner. May be given several times.")
  private void swaps(List<String> texts) {
    swaps = parsed("--swap", () -> texts.stream().map(SwapOperator.PlannedSwap::parse).toList());
  }

  @Option(
      names = "--set",
      paramLabel = "SERVICE:VARIABLE=VALUE",
      description =
          "Set a configuration variable for this run, for example --set \"SafetyManager:ON FENCE=LAND\". May be given several times.")
  private void settings(List<String> texts) {
    settings = parsed("--set", () -> Setting.parseAll(texts));
  }

  /** The requested swaps. */
  List<SwapOperator.PlannedSwap> swaps() {
    return swaps;
  }

  /**
   * Rejects settings that have no effect in the system.
   *
   * @throws ParameterException if a setting names a service not in the system
   */
  void check(SystemFile system) {
    parsed(
        "--set",
        () -> {
          settings.forEach(setting -> setting.requireServiceOf(system));
          return system;
        });
  }

  /** Applies the requested variables to a run. */
  void applyTo(LaunchOptions options) {
    settings.forEach(
        setting -> options.override(setting.service(), setting.variable(), setting.value()));
  }

  /** Stores the run's settings in a recording. */
  RunFacts addTo(RunFacts facts) {
    settings.forEach(
        setting -> facts.setting(setting.service(), setting.variable(), setting.value()));
    return facts;
  }

  private <T> T parsed(String option, Supplier<T> parse) {
    try {
      return parse.get();
    } catch (IllegalArgumentException e) {
      throw new ParameterException(command.commandLine(), option + ": " + e.getMessage());
    }
  }
}
