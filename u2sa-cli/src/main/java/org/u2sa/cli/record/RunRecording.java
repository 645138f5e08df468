package org.u2sa.cli.record;

import org.u2sa.core.launch.LaunchOptions;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Options for recording a run; used as {@code @Mixin RunRecording recording}. */
public final class RunRecording {
  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  @Mixin private RecordOptions options;

  @Option(names = "--record", description = "Record every message of the run, in recording.mcap.")
  private boolean record;

  /**
   * Rejects recording options without --record.
   *
   * @throws ParameterException naming --record
   */
  public void check() {
    if (!record && options.isAnyGiven()) {
      throw new ParameterException(
          command.commandLine(), "--split, --keep and --form: expected --record as well");
    }
  }

  /** Whether a recording is made. */
  public boolean isWanted() {
    return record;
  }

  /**
   * Sets up the recording of the run, if requested.
   *
   * @param folder folder of the recording, relative to the log folder; empty or ending with a slash
   */
  public void addTo(LaunchOptions launch, String folder, RunFacts facts) {
    if (record) {
      options.addTo(launch, folder + "recording.mcap", facts);
    }
  }
}
