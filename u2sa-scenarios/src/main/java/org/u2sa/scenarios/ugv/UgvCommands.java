package org.u2sa.scenarios.ugv;

import java.util.List;
import org.u2sa.cli.command.CommandProvider;

/** Registers the ground vehicle demo with the command line. */
public final class UgvCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(new Contribution(Group.DEMO, new UgvDemo()));
  }
}
