package org.u2sa.trials.simulate;

import java.util.List;
import org.u2sa.cli.command.CommandProvider;

/** Registers {@code simulate} and {@code vehicle} with the command line. */
public final class SimulateCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(
        new Contribution(Group.TOP_LEVEL, new SimulateCommand()),
        new Contribution(Group.TOP_LEVEL, new VehicleCommand()));
  }
}
