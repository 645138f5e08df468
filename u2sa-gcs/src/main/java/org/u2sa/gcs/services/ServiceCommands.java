package org.u2sa.gcs.services;

import java.util.List;
import org.u2sa.gcs.command.CommandProvider;

/** Adds the commands that see and order the services of a running system. */
public final class ServiceCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(
        new Contribution(Group.TOP_LEVEL, new ServicesCommand()),
        new Contribution(Group.TOP_LEVEL, new GraphCommand()),
        new Contribution(Group.TOP_LEVEL, new StopServicesCommand()),
        new Contribution(Group.TOP_LEVEL, new RestartCommand()),
        new Contribution(Group.TOP_LEVEL, new SwapCommand()));
  }
}
