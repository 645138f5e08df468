package org.u2sa.scenarios.encounters;

import java.util.List;
import org.u2sa.cli.command.CommandProvider;

/** Adds the encounters demo to the command line. */
public final class EncounterCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(new Contribution(Group.DEMO, new EncounterDemo()));
  }
}
