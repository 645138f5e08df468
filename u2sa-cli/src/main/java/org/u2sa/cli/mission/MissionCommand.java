package org.u2sa.cli.mission;

import org.u2sa.cli.command.BaseCommand;
import picocli.CommandLine.Command;

/** {@code u2sa mission}: prints its help. */
@Command(
    name = "mission",
    description = {
      "Show the mission of a running system, change it while it runs, or convert mission files.",
      "",
      "  ./u2sa mission show",
      "  ./u2sa mission goto dock",
      "  ./u2sa mission insert detour.xml --after gate",
      "  ./u2sa mission import survey.plan",
      "",
      "The Mission Manager answers each order. Exit code 1: the order was refused, or no answer "
          + "came."
    },
    subcommands = {
      ShowMissionCommand.class,
      OrderCommand.GoTo.class,
      OrderCommand.Skip.class,
      OrderCommand.Insert.class,
      OrderCommand.Update.class,
      OrderCommand.Pause.class,
      OrderCommand.Resume.class,
      OrderCommand.Return.class,
      MissionFileCommand.Import.class,
      MissionFileCommand.Export.class
    })
public final class MissionCommand extends BaseCommand.Group {}
