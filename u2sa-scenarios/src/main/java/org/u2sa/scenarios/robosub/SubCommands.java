package org.u2sa.scenarios.robosub;

import java.util.List;
import org.u2sa.cli.command.CommandProvider;

/** Adds the RoboSub demo to the command line. */
public final class SubCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(new Contribution(Group.DEMO, new RoboSubDemo()));
  }
}
