package org.u2sa.scenarios.suas;

import java.util.List;
import org.u2sa.cli.command.CommandProvider;

/** Adds the SUAS demo to the command line. */
public final class SuasCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(new Contribution(Group.DEMO, new SuasDemo()));
  }
}
