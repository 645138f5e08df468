package org.u2sa.spark;

import java.util.List;
import org.u2sa.cli.command.CommandProvider;

/** Adds {@link TrialCommand} where tests are on the class path. */
public final class TrialCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(new Contribution(Group.TOP_LEVEL, new TrialCommand()));
  }
}
