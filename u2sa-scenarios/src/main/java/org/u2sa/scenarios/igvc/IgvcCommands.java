package org.u2sa.scenarios.igvc;

import java.util.List;
import org.u2sa.cli.command.CommandProvider;

/** Adds the IGVC demo to the command line. */
public final class IgvcCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(new Contribution(Group.DEMO, new IgvcDemo()));
  }
}
