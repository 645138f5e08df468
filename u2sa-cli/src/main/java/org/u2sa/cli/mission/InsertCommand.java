package org.u2sa.cli.mission;

import java.nio.file.Path;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code u2sa mission insert}. */
@Command(
    name = "insert",
    description = {
      "Insert the goals of a mission file.",
      "",
      "What followed that goal follows them. Names must be new; a next may name goals of the mission."
    })
final class InsertCommand extends OrderCommand {
  @Parameters(paramLabel = "FILE", description = "A mission file with goals only.")
  private Path file;

  @ArgGroup private Place place = new Place();

  /** Mutually exclusive options. */
  private static final class Place {
    @Option(
        names = "--after",
        paramLabel = "GOAL",
        description = "The goal that they follow. Default: the current one.")
    private String after;

    @Option(names = "--now", description = "Pursue them at once; the current goal follows them.")
    private boolean now;
  }

  @Override
  MissionOrder order() {
    MissionOrder order = OrderToMissionManager.withGoals(MissionAction.INSERT, file).now(place.now);
    return place.after == null ? order : order.uid(place.after);
  }
}
