package org.u2sa.gcs.dependencies;

import java.util.List;
import org.u2sa.gcs.command.CommandProvider;

/** Adds the command that lists libraries. */
public final class DependencyCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(new Contribution(Group.TOP_LEVEL, new DependenciesCommand()));
  }
}
