package org.u2sa.scenarios.vrx;

import java.util.List;
import org.u2sa.cli.command.CommandProvider;

/** Adds the tasks of VRX to the command line. */
public final class VrxCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(
        new Contribution(Group.DEMO, new VrxDemo()), new Contribution(Group.DEMO, new VrxTable()));
  }
}
