package org.u2sa.scenarios.roboboat;

import java.util.List;
import org.u2sa.cli.command.CommandProvider;

/** Adds the RoboBoat demo to the command line. */
public final class RoboBoatCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(new Contribution(Group.DEMO, new RoboBoatDemo()));
  }
}
