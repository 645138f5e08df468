package org.u2sa.scenarios.cessna;

import java.util.List;
import org.u2sa.cli.command.CommandProvider;

/** Adds the Cessna's commands to the command line. */
public final class CessnaCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(
        new Contribution(Group.DEMO, new CessnaDemo()),
        new Contribution(Group.TOP_LEVEL, new FlyCommand()));
  }
}
